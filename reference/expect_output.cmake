# STAFF ONLY. Runs PROGRAM and compares its whole output with EXPECTED.
execute_process(COMMAND "${PROGRAM}" OUTPUT_VARIABLE output ERROR_VARIABLE error RESULT_VARIABLE result)
if(NOT result EQUAL 0 OR NOT error STREQUAL "")
  message(FATAL_ERROR "${PROGRAM} ended with ${result}, saying: ${error}")
endif()
if(NOT output STREQUAL EXPECTED)
  message(FATAL_ERROR "${PROGRAM} printed\n${output}where this was expected:\n${EXPECTED}")
endif()
