# What was unpacked is compiled, also over a folder that is built: its files may be older than what was built
# of those before them. So the archive holds cmake/just-unpacked. Configuring makes the given files as new as
# now, and takes it away. Each build looks whether it is there again.
set(unpacked "${CMAKE_SOURCE_DIR}/cmake/just-unpacked")
if(EXISTS "${unpacked}")
  set(given given check exercises solver particles hair)
  list(TRANSFORM given REPLACE "(.+)" "${CMAKE_SOURCE_DIR}/\\1/*")
  file(GLOB_RECURSE given ${given})
  file(TOUCH ${given})
  file(REMOVE "${unpacked}")
endif()
file(GLOB unpacked CONFIGURE_DEPENDS "${unpacked}")
