# STAFF ONLY. Tests. Each has one of three labels, and the target of that name builds the programs that it
# runs:
#
#   quick       for every change, optimised: in .ci/run and in ./grader/check
#   sanitised   for every change, too; .ci/run runs it with sanitisers, ./grader/check without
#   slow        in ./grader/check --all
#
# .ci/nightly runs all of them, optimised and with sanitisers.
#   hair_test(NAME [SANITISED] [SLOW CASES] SOURCES ... LIBRARIES ...)
#       a GoogleTest program of our own and its test, both called NAME: quick, or sanitised. Long cases are
#       a test of their own, NAME.slow: SLOW names them as --gtest_filter does
#   hair_program_test(LABEL NAME PROGRAM ARGUMENT...)
#       the test NAME, which starts the target PROGRAM with these arguments
#   hair_command_test(LABEL NAME PROGRAM COMMAND...)
#       the test NAME, which starts a command for the target PROGRAM
add_custom_target(quick)
add_custom_target(sanitised)
add_custom_target(slow)

function(hair_command_test LABEL NAME PROGRAM)
  add_test(NAME ${NAME} COMMAND ${ARGN})
  set_tests_properties(${NAME} PROPERTIES LABELS ${LABEL})
  add_dependencies(${LABEL} ${PROGRAM})
endfunction()

function(hair_program_test LABEL NAME PROGRAM)
  hair_command_test(${LABEL} ${NAME} ${PROGRAM} ${PROGRAM} ${ARGN})
endfunction()

# Tests compile in a quarter less time with less optimisation than the tested code. Those of a folder that
# sets HAIR_TEST_KIND to plain_test calculate little: without optimisation and without Eigen they take another
# third less.
set(HAIR_TEST_KIND test)
set(HAIR_OPTIONS_OF_test $<$<CONFIG:Release>:-O1>)
set(HAIR_OPTIONS_OF_plain_test $<$<CONFIG:Release>:-O0>)
set(headers ${HAIR_USUAL_HEADERS})
list(FILTER headers EXCLUDE REGEX Eigen)
hair_precompiled(test PROGRAM HEADERS ${HAIR_USUAL_HEADERS} <gtest/gtest.h> LIBRARIES GTest::gtest
                 Eigen3::Eigen)
hair_precompiled(plain_test PROGRAM HEADERS ${headers} <gtest/gtest.h> LIBRARIES GTest::gtest)
unset(headers)
if(HAIR_PRECOMPILED)
  foreach(kind test plain_test)
    target_compile_options(hair_precompiled_${kind} PRIVATE ${HAIR_OPTIONS_OF_${kind}})
  endforeach()
endif()

function(hair_test_code TARGET)
  hair_own_code(${TARGET})
  target_compile_options(${TARGET} PRIVATE ${HAIR_OPTIONS_OF_${HAIR_TEST_KIND}})
  hair_precompile(${TARGET} ${HAIR_TEST_KIND})
endfunction()

function(hair_test NAME)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "SANITISED" "SLOW" "SOURCES;LIBRARIES")
  find_package(GTest REQUIRED)
  add_executable(${NAME} ${ARG_SOURCES})
  hair_test_code(${NAME})
  target_link_libraries(${NAME} PRIVATE ${ARG_LIBRARIES} hair_dense_algebra GTest::gtest_main)
  set(label quick)
  if(ARG_SANITISED)
    set(label sanitised)
  endif()
  if(ARG_SLOW)
    hair_program_test(${label} ${NAME} ${NAME} "--gtest_filter=-${ARG_SLOW}")
    hair_program_test(slow ${NAME}.slow ${NAME} "--gtest_filter=${ARG_SLOW}")
    set_tests_properties(${NAME}.slow PROPERTIES FAIL_REGULAR_EXPRESSION "Running 0 tests")
  else()
    hair_program_test(${label} ${NAME} ${NAME})
  endif()
endfunction()
