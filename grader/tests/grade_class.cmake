# STAFF ONLY. Grades CLASS, a folder of samples, from scratch into OUT.
file(REMOVE_RECURSE "${OUT}" "${OUT}-cache")
execute_process(COMMAND "${HAIRGRADE}" grade "${CLASS}" --out "${OUT}" --cache "${OUT}-cache" --secret "${SECRET}"
                RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
file(REMOVE_RECURSE "${OUT}-cache")
if(NOT result EQUAL 0)
  message(FATAL_ERROR "hairgrade ended with ${result}:\n${output}")
endif()
