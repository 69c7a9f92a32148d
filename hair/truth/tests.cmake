# STAFF ONLY. Accurate motions, with the reference.
list(TRANSFORM HAIR_EXERCISES PREPEND reference_ OUTPUT_VARIABLE exercises)
hair_test(accurate_motion_test SOURCES accurate_motion_test.cpp
    strand_ode_test.cpp LIBRARIES hair_truth hair_scene hair_simulation ${exercises})
