# Refuses folders whose names break CMake, or a program that it starts; CMake's own messages do not help.
# This comes before project(), which compiles first programs. Ninja does not read all letters in compilers'
# lists of headers: it would compile everything in each build.
string(ASCII 1 first)
string(ASCII 31 last)
set(refused "[]#;\"\\<>?|,:=*${first}-${last}[]|[$][({]")
if(CMAKE_GENERATOR MATCHES "Ninja")
  string(APPEND refused "|[&'^`]")
endif()
foreach(folder "${CMAKE_SOURCE_DIR}" "${CMAKE_BINARY_DIR}")
  if(folder MATCHES "(${refused})")
    message(FATAL_ERROR
            "\"${folder}\" can't be built in: CMake takes no \"${CMAKE_MATCH_1}\" in a folder's name. "
            "Move it to a folder without any of # ; \" \\ < > ? | [ ] , : = * tab \$( \${, "
            "and for Ninja & ' ^ `")
  endif()
endforeach()
