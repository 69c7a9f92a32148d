# STAFF ONLY. Scenes: reading them, and running them with the reference.
list(TRANSFORM HAIR_EXERCISES PREPEND reference_ OUTPUT_VARIABLE exercises)
set(scenes "${PROJECT_SOURCE_DIR}/hair/scenes")

function(scene_test NAME)
  hair_test(${ARGV})
  target_compile_definitions(${NAME} PRIVATE HAIR_SCENES="${scenes}")
endfunction()

scene_test(read_scene_test SANITISED SOURCES read_scene_test.cpp read_bad_scene_test.cpp read_groom_test.cpp
           test_reading.cpp
           LIBRARIES hair_scene hair_simulation ${exercises})
scene_test(scene_run_test SANITISED SOURCES angular_momentum_test.cpp scene_run_test.cpp
           LIBRARIES hair_allocations hair_scene hair_simulation ${exercises})
scene_test(shipped_scenes_test SLOW Watch.NoOtherShippedSceneWarns
           SOURCES shipped_scenes_test.cpp watch_test.cpp LIBRARIES hair_scene hair_simulation ${exercises})

# A course without any exercise.
hair_left_out(not_in_course ${HAIR_EXERCISES})
scene_test(not_in_course_test SANITISED SOURCES not_in_course_test.cpp LIBRARIES hair_scene hair_simulation
           not_in_course)

# With one exercise's stub among the reference, the scenes that need it stop there and name it, and the others
# run.
add_library(exercises_of_test OBJECT exercises_of_test.cpp)
hair_own_code(exercises_of_test)
target_link_libraries(exercises_of_test PRIVATE hair_scene_drawing hair_scene GTest::gtest)
target_compile_definitions(exercises_of_test PRIVATE HAIR_SCENES="${scenes}")
foreach(id ${HAIR_EXERCISES})
  # With sanitisers two programs are enough, because all read and draw the same scenes: S2's stub stops
  # none of them, and H10's stops some when they are drawn.
  if(HAIR_RELEASE_BUILD AND NOT id MATCHES "^(S2|H10)$")
    continue()
  endif()
  file(CONFIGURE OUTPUT stub_${id}.cpp
       CONTENT "extern const char* const kStub;\nconst char* const kStub = \"${id}\";\n")
  hair_test(exercises_of_${id}_test SOURCES "${CMAKE_CURRENT_BINARY_DIR}/stub_${id}.cpp"
            $<TARGET_OBJECTS:exercises_of_test>
            $<TARGET_OBJECTS:student_${id}> LIBRARIES hair_scene_drawing hair_scene hair_simulation
            ${exercises})
endforeach()
