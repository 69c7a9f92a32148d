# The lecture's programs.
#
#   hair_lecture_examples(NAME_PREFIX EXERCISE_LIB_PREFIX)
#     <NAME_PREFIX>_example1 and 2, linked with the exercise library <EXERCISE_LIB_PREFIX>_S1, and _example3
#     with _S2, if their exercises are in the course

function(hair_lecture_examples NAME_PREFIX EXERCISE_LIB_PREFIX)
  foreach(example_of 1:S1 2:S1 3:S2)
    string(REPLACE ":" ";" example_of ${example_of})
    list(GET example_of 0 example)
    list(GET example_of 1 exercise)
    if(NOT TARGET ${EXERCISE_LIB_PREFIX}_${exercise})
      continue()
    endif()
    set(name ${NAME_PREFIX}_example${example})
    add_executable(${name} "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/example${example}.cpp")
    hair_compile_settings(${name})
    foreach(called ${exercise} ${HAIR_${exercise}_PREREQUISITES})
      target_link_libraries(${name} PRIVATE ${EXERCISE_LIB_PREFIX}_${called})
    endforeach()
    target_link_libraries(${name} PRIVATE hair_solver hair_filled_blocks)
  endforeach()
endfunction()
