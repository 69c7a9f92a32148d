# STAFF ONLY. With all of the reference's exercises.
list(TRANSFORM HAIR_EXERCISES PREPEND reference_ OUTPUT_VARIABLE exercises)
hair_test(force_bands_test SOURCES force_bands_test.cpp LIBRARIES hair_strand_states hair_simulation
          ${exercises} hair_check)
hair_test(rest_curvature_test SOURCES rest_curvature_test.cpp
          LIBRARIES hair_strand_states hair_simulation ${exercises} hair_check)
