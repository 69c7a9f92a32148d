# hairlab's parts, and hairlab from outside: with the exercises solved, and with the stubs.

# The library that reads scenes also calls exercises; these tests call none.
list(TRANSFORM HAIR_EXERCISES PREPEND student_ OUTPUT_VARIABLE exercises)
hair_test(hairlab_test
  SOURCES explain_test.cpp groom_commands_test.cpp hairlab_test.cpp
  hand_over_test.cpp output_folder_test.cpp test_run_hairlab.cpp states_file_test.cpp
  LIBRARIES hair_lab hair_scene_drawing hair_scene hair_simulation ${exercises} nlohmann_json::nlohmann_json)
target_compile_definitions(hairlab_test PRIVATE HAIRLAB="$<TARGET_FILE:hairlab>"
    STUDENT_HAIRLAB="$<TARGET_FILE:student_hairlab>"
                           HAIR_SCENES_DIR="${PROJECT_SOURCE_DIR}/hair/scenes"
                           HAIR_PROJECT="${PROJECT_SOURCE_DIR}"
                           HAIR_BUILD_DIR="${PROJECT_BINARY_DIR}"
                           HAIR_EXERCISES_JSON="${HAIR_HANDOUT_DIR}/exercises.json")
add_dependencies(hairlab_test hairlab hairlab_grooms student_hairlab hair_motions)

# Tests of its studies.
hair_test(study_commands_test SOURCES test_run_hairlab.cpp studies_test.cpp study_commands_test.cpp
    study_pages_test.cpp LIBRARIES hair_lab_shows
    hair_lab_studies hair_head_study hair_stability hair_validate hair_study hair_truth hair_scene
    hair_simulation ${exercises} nlohmann_json::nlohmann_json)
target_compile_definitions(study_commands_test PRIVATE HAIRLAB="$<TARGET_FILE:hairlab>"
    STUDENT_HAIRLAB="$<TARGET_FILE:student_hairlab>")
add_dependencies(study_commands_test hairlab_shows hairlab_studies student_hairlab_shows
                 student_hairlab_studies)
