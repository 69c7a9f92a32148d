# STAFF ONLY. Fuzz programs: hostile bytes for a reader, made by libFuzzer. Preset `fuzz` links them, and each
# is a test there, of a minute. Other presets know their sources, so that .ci/nightly looks at them, and build
# nothing.
#
#   hair_fuzz(NAME SOURCES ... LIBRARIES ...)   a program of ours, build/fuzz/programs/NAME, whose sources
#                                               define what hair/io/fuzz/fuzz.h says
option(HAIR_FUZZ "Link the fuzz programs; asks for clang++ and -fsanitize=fuzzer-no-link" OFF)
if(HAIR_FUZZ)
  enable_testing()
  add_custom_target(fuzz)
endif()

function(hair_fuzz NAME)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "SOURCES;LIBRARIES")
  set(sources ${ARG_SOURCES})
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")  # it includes a header that clang alone has
    list(APPEND sources "${PROJECT_SOURCE_DIR}/hair/io/fuzz/fuzz.cpp")
  endif()
  if(HAIR_FUZZ)
    add_executable(${NAME} EXCLUDE_FROM_ALL ${sources})
    target_link_options(${NAME} PRIVATE -fsanitize=fuzzer)
    set_target_properties(${NAME} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/programs")
    hair_command_test(fuzz ${NAME} ${NAME} "${PROJECT_SOURCE_DIR}/grader/tests/fuzz" $<TARGET_FILE:${NAME}>)
  else()
    add_library(${NAME} OBJECT EXCLUDE_FROM_ALL ${sources})
  endif()
  hair_own_code(${NAME})
  target_include_directories(${NAME} PRIVATE "${PROJECT_SOURCE_DIR}")
  target_link_libraries(${NAME} PRIVATE ${ARG_LIBRARIES})
endfunction()
