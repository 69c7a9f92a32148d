# Writes OUT, a C++ file with the names of a program's stubs. FILES are the sources of its exercises, in which
# a stub throws NotImplemented("H1 stretch_energy"). Ignores comments. If nothing is new, OUT stays as it is,
# and nothing is compiled.
set(stubs)
foreach(file ${FILES})
  file(READ "${file}" text)
  string(REGEX REPLACE "//[^\n]*" "" text "${text}")
  string(REGEX MATCHALL "NotImplemented[({]\"[A-Za-z0-9_ ]+\"" found "${text}")
  foreach(stub ${found})
    string(REGEX REPLACE "[^\"]*\"([^\"]*)\"" "\\1" stub "${stub}")
    string(APPEND stubs "${stub}\\n")
  endforeach()
endforeach()
string(CONCAT text "// Made by hair/lab/stubs.cmake of the exercises' files.\n\nnamespace hair {\n\n"
                   "extern const char* const kStubs;\nconst char* const kStubs = \"${stubs}\";\n\n"
                   "}  // namespace hair\n")
set(before)
if(EXISTS "${OUT}")
  file(READ "${OUT}" before)
endif()
if(NOT text STREQUAL before)
  file(WRITE "${OUT}" "${text}")
endif()
