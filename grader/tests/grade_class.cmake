# STAFF ONLY. Grades CLASS, a folder of samples, from scratch into OUT, then the sample AGAIN once more into
# OUT-again. Compiled files stay in OUT-cache: public_checks_test reads them there.
file(REMOVE_RECURSE "${OUT}" "${OUT}-again" "${OUT}-cache")
foreach(arguments "--out;${OUT}" "--out;${OUT}-again;--only;${AGAIN}")
  execute_process(COMMAND "${HAIRGRADE}" grade "${CLASS}" --cache "${OUT}-cache" --secret "${SECRET}"
                  ${arguments}
                  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result MATCHES "^[03]$")  # 3: a person must look at some hand-ins
    message(FATAL_ERROR "hairgrade ended with ${result}:\n${output}")
  endif()
endforeach()
