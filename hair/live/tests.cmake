# STAFF ONLY. Tests of hairlab live: its parts, and the program from outside.
list(TRANSFORM HAIR_EXERCISES PREPEND student_ OUTPUT_VARIABLE exercises)
hair_test(hair_live_test SOURCES child_test.cpp live_parts_test.cpp live_settings_test.cpp
          LIBRARIES hair_live hair_lab hair_scene_drawing hair_scene hair_no_groom_files hair_simulation
          ${exercises})
target_compile_definitions(hair_live_test PRIVATE HAIR_SCENES_DIR="${PROJECT_SOURCE_DIR}/hair/scenes"
    HAIR_EXERCISES_JSON="${HAIR_HANDOUT_DIR}/exercises.json")
# The test looks for the name of an exercise's library.
add_library(hair_live_lost SHARED test_lost.cpp)
set_target_properties(hair_live_lost PROPERTIES OUTPUT_NAME student_H6 LIBRARY_OUTPUT_DIRECTORY
                      "${CMAKE_CURRENT_BINARY_DIR}/lost")
hair_test(hair_whereabouts_test SOURCES whereabouts_test.cpp whereabouts.cpp LIBRARIES hair_live_lost)
hair_test(hairlab_live_test SOURCES hairlab_live_test.cpp LIBRARIES hair_files)
target_compile_definitions(hairlab_live_test PRIVATE HAIRLAB="$<TARGET_FILE:hairlab>"
    STUDENT_HAIRLAB="$<TARGET_FILE:student_hairlab>")
add_dependencies(hairlab_live_test hairlab_live student_hairlab_live)
