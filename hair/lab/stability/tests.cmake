# STAFF ONLY. Stability maps, with the reference.
list(TRANSFORM HAIR_EXERCISES PREPEND reference_ OUTPUT_VARIABLE exercises)
hair_test(stability_test SOURCES extremes_test.cpp stability_page_test.cpp stability_maps_test.cpp LIBRARIES
    hair_stability hair_study hair_truth
    hair_scene hair_simulation ${exercises})
