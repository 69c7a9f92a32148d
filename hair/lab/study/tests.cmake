# STAFF ONLY. Studies with the reference: known orders, and wrong methods.
list(TRANSFORM HAIR_EXERCISES PREPEND reference_ OUTPUT_VARIABLE exercises)
set(libraries hair_study hair_truth hair_scene hair_simulation ${exercises})

hair_test(study_test SLOW KnownOrders.OfSoftHair SOURCES known_orders_test.cpp written_down.cpp
    test_studies.cpp LIBRARIES hair_written_down ${libraries})
hair_test(wrong_method_test SOURCES wrong_method_test.cpp test_studies.cpp
    "${HAIR_HANDOUT_DIR}/exercises/H6/${HAIR_H6_FILE}" LIBRARIES ${libraries})
