# STAFF ONLY. The study of a head, with the reference and without an engine.
list(TRANSFORM HAIR_EXERCISES PREPEND reference_ OUTPUT_VARIABLE exercises)
hair_test(head_study_test SOURCES head_page_test.cpp head_study_test.cpp
          LIBRARIES hair_head_study hair_scene hair_simulation ${exercises} nlohmann_json::nlohmann_json)
