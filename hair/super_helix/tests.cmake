# STAFF ONLY. Super-helices with the reference's H8.
list(TRANSFORM HAIR_EXERCISES PREPEND reference_ OUTPUT_VARIABLE exercises)
hair_test(super_helix_body_test SOURCES super_helix_body_test.cpp LIBRARIES hair_simulation ${exercises})
