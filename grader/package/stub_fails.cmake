# STAFF ONLY. Passes if PROGRAM, the public checks with a stub, fails and prints exactly SENTENCES, which have
# a | between them, one to a line.
execute_process(COMMAND "${PROGRAM}" RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT result EQUAL 1)
  message(FATAL_ERROR
          "with a stub the checks ended with ${result}; they must fail, with 1. They print:\n${output}")
endif()
string(REPLACE "|" "\n" expected "${SENTENCES}")
if(NOT output STREQUAL "${expected}\n")
  message(FATAL_ERROR "with a stub the checks print\n${output}They must print\n${expected}")
endif()
