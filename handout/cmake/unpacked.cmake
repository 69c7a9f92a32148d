# A handout that is unpacked over a built folder is compiled anew, although its files may be older than the
# objects there. The archive holds cmake/just-unpacked. If this file is there, configuring touches the given
# files and removes it. Each build looks for it again.
set(unpacked "${CMAKE_SOURCE_DIR}/cmake/just-unpacked")
if(EXISTS "${unpacked}")
  set(given given check exercises solver particles hair)
  list(TRANSFORM given REPLACE "(.+)" "${CMAKE_SOURCE_DIR}/\\1/*")
  file(GLOB_RECURSE given ${given})
  file(TOUCH ${given})
  file(REMOVE "${unpacked}")
endif()
file(GLOB unpacked CONFIGURE_DEPENDS "${unpacked}")
