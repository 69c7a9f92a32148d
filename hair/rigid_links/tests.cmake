# STAFF ONLY. Strands of rigid links with the reference's H7.
list(TRANSFORM HAIR_EXERCISES PREPEND reference_ OUTPUT_VARIABLE exercises)
hair_test(rigid_links_body_test SOURCES rigid_links_body_test.cpp LIBRARIES hair_simulation ${exercises})
