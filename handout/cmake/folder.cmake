# Refuses folders whose names CMake, or what it starts, can't hold: what it says of them itself is no help. It comes before project(),
# which compiles first programs.
foreach(folder "${CMAKE_SOURCE_DIR}" "${CMAKE_BINARY_DIR}")
  if(folder MATCHES "([]#;\"\\<>?|[]|[$]{)")
    message(FATAL_ERROR "\"${folder}\" can't be built in: CMake takes no ${CMAKE_MATCH_1} in a folder's name. Move it to a folder without any of # ; \" \\ < > ? | [ ] and \${")
  endif()
endforeach()
