# The lecture's programs.
#
#   hair_lecture_examples(NAME_PREFIX EXERCISE_LIB_PREFIX)
#     <NAME_PREFIX>_example1 .. 3, linked with the exercise libraries <EXERCISE_LIB_PREFIX>_S1 and _S2

function(hair_lecture_examples NAME_PREFIX EXERCISE_LIB_PREFIX)
  foreach(example 1 2 3)
    set(name ${NAME_PREFIX}_example${example})
    add_executable(${name} "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/example${example}.cpp")
    hair_compile_settings(${name})
    # The lecture includes "linearSolver.h", without a folder.
    target_include_directories(${name} PRIVATE "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/..")
  endforeach()
  target_link_libraries(${NAME_PREFIX}_example1 PRIVATE ${EXERCISE_LIB_PREFIX}_S1)
  target_link_libraries(${NAME_PREFIX}_example2 PRIVATE ${EXERCISE_LIB_PREFIX}_S1)
  target_link_libraries(${NAME_PREFIX}_example3 PRIVATE ${EXERCISE_LIB_PREFIX}_S2 hair_solver)
endfunction()
