# Precompiled headers: Eigen and GoogleTest take 1.3 to 1.8 CPU seconds in each file that includes them, and a
# tenth of that once they are precompiled. JSON is not among them: a precompiled one saves 0.5 s where it is
# included, and costs each other file 0.9 s, for its literals make the compiler write out a whole parser. A
# precompiled header serves only files that are compiled with its options: each kind has its own.
#
#   hair_precompiled(KIND [PROGRAM] HEADERS ... LIBRARIES ...)
#                                  the target hair_precompiled_<KIND>, compiled as a library or a program with
#                                  these libraries; it is made when the first target asks for it
#   hair_precompile(TARGET KIND)   compiles TARGET with it, if it is there
#   HAIR_USUAL_HEADERS             the headers of Eigen and of the standard library that our own code includes
option(HAIR_PRECOMPILED "Compile with precompiled headers" ON)
if(HAIR_PRECOMPILED)
  set(CMAKE_POSITION_INDEPENDENT_CODE ON)
  # With this ccache knows the contents of a precompiled header.
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>
                      "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")
endif()

set(HAIR_USUAL_HEADERS
    <Eigen/Cholesky> <Eigen/Core> <Eigen/Geometry> <Eigen/LU> <algorithm> <array> <atomic> <chrono> <cmath>
    <cstdint> <filesystem> <fstream> <functional> <map> <memory> <numeric> <optional> <random> <set> <span>
    <sstream> <stdexcept> <string> <string_view> <thread> <tuple> <utility> <variant> <vector>)

function(hair_precompiled KIND)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "PROGRAM" "" "HEADERS;LIBRARIES")
  if(NOT HAIR_PRECOMPILED)
    return()
  endif()
  set(source "${CMAKE_CURRENT_BINARY_DIR}/precompiled.cpp")
  file(CONFIGURE OUTPUT "${source}" CONTENT "int main() {}\n")
  set(target hair_precompiled_${KIND})
  if(ARG_PROGRAM)
    add_executable(${target} EXCLUDE_FROM_ALL "${source}")
  else()
    add_library(${target} OBJECT EXCLUDE_FROM_ALL "${source}")
  endif()
  hair_warnings(${target})
  if(KIND MATCHES "exercise$")
    target_compile_options(${target} PRIVATE ${HAIR_FASTEST})
  endif()
  target_link_libraries(${target} PRIVATE ${ARG_LIBRARIES})
  target_precompile_headers(${target} PRIVATE ${ARG_HEADERS})
endfunction()

function(hair_precompile TARGET KIND)
  if(TARGET hair_precompiled_${KIND})
    target_precompile_headers(${TARGET} REUSE_FROM hair_precompiled_${KIND})
  endif()
endfunction()
