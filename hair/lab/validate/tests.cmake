# STAFF ONLY. With the reference: all validations hold, and what is wrong does not.
list(TRANSFORM HAIR_EXERCISES PREPEND reference_ OUTPUT_VARIABLE exercises)
hair_test(validations_test SOURCES validations_test.cpp
          LIBRARIES hair_validate hair_scene hair_simulation ${exercises} nlohmann_json::nlohmann_json)
