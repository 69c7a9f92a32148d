# Refuses folders whose names CMake, or what it starts, can't hold: what it says of them itself is no help. It
# comes before project(), which compiles first programs. In compilers' lists of headers Ninja does not read
# all letters: it would compile everything in each build.
string(ASCII 1 first)
string(ASCII 31 last)
set(refused "[]#;\"\\<>?|,:=*${first}-${last}[]|[$][({]")
if(CMAKE_GENERATOR MATCHES "Ninja")
  string(APPEND refused "|[&'^`]")
endif()
foreach(folder "${CMAKE_SOURCE_DIR}" "${CMAKE_BINARY_DIR}")
  if(folder MATCHES "(${refused})")
    message(FATAL_ERROR "\"${folder}\" can't be built in: CMake takes no \"${CMAKE_MATCH_1}\" in a folder's name. Move it to a folder without any of # ; \" \\ < > ? | [ ] , : = * tab \$( \${, and for Ninja & ' ^ `")
  endif()
endforeach()
