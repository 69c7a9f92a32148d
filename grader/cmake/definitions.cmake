# STAFF ONLY. HAIR_PROVIDED lists the exercises that are others' prerequisites. Definitions of an exercise's
# functions that call another process are made of their signatures in exercises.json:
#
#   hair_definitions(OUT ID ASKED)  writes the file OUT: each function of exercise ID calls
#       grader::proxied<Calls, function>(arguments...) of the header ASKED. reference/<ID>/proxies.h
#       replaces it.
function(hair_definitions OUT ID ASKED)
  string(TOLOWER ${ID} space)
  string(CONCAT text
         "// STAFF ONLY. ${ID}'s functions, asked of somebody else. Made by grader/cmake/definitions.cmake.\n"
         "#include \"reference/${ID}/calls.h\"\n#include \"${ASKED}\"\n")
  if(EXISTS "${PROJECT_SOURCE_DIR}/reference/${ID}/proxies.h")
    string(APPEND text "#include \"reference/${ID}/proxies.h\"\n")
  else()
    foreach(signature ${HAIR_${ID}_FUNCTIONS})
      string(REGEX REPLACE "[(].*" "" name "${signature}")
      # Keeps commas between parameters, but none within a type.
      string(REGEX REPLACE "^[^(]*[(](.*)[)]$" "\\1" parameters "${signature}")
      foreach(depth RANGE 3)
        string(REGEX REPLACE "<[^<>]*>" "" parameters "${parameters}")
      endforeach()
      string(REGEX MATCHALL "," commas "${parameters}")
      list(LENGTH commas last)
      set(declared)
      set(passed)
      foreach(i RANGE ${last})
        list(APPEND declared "grader::ParameterOf<${name}, ${i}> a${i}")
        list(APPEND passed "a${i}")
      endforeach()
      list(JOIN declared ", " declared)
      list(JOIN passed ", " passed)
      string(APPEND text
             "\ngrader::ResultOf<${name}> ${name}(${declared}) {\n"
             "  return grader::proxied<grader::${space}::Calls, ${name}>(${passed});\n}\n")
    endforeach()
  endif()
  file(CONFIGURE OUTPUT "${OUT}" CONTENT "${text}" @ONLY)
endfunction()

# These exercises are others' prerequisites: the suite provides their functions.
set(HAIR_PROVIDED)
foreach(id ${HAIR_EXERCISES})
  list(APPEND HAIR_PROVIDED ${HAIR_${id}_PREREQUISITES})
endforeach()
list(REMOVE_DUPLICATES HAIR_PROVIDED)
