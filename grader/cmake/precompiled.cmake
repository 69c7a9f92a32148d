# STAFF ONLY. Precompiled headers: Eigen, JSON and GoogleTest take 1.3 to 1.8 CPU seconds in each file that includes them, and a
# tenth of that once they are precompiled. Reference and samples are compiled without, as students' files are.
#
#   hair_precompile(TARGET)        for a library: Eigen, JSON, the standard library
#   hair_precompile_test(TARGET)   for a program of tests: GoogleTest, too
option(HAIR_PRECOMPILED "Compile with precompiled headers" ON)
if(NOT HAIR_PRECOMPILED)
  return()
endif()

# A precompiled header serves only what is compiled with its options, so that these are the same everywhere.
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
# What ccache needs to know what a precompiled header holds.
add_compile_options($<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess> "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")
find_package(GTest REQUIRED)
find_package(nlohmann_json REQUIRED)

set(headers <Eigen/Cholesky> <Eigen/Core> <Eigen/Geometry> <Eigen/LU> <nlohmann/json.hpp> <algorithm> <array> <atomic> <chrono>
            <cmath> <cstdint> <filesystem> <fstream> <functional> <map> <memory> <numeric> <optional> <random> <set> <span>
            <sstream> <stdexcept> <string> <string_view> <thread> <tuple> <utility> <variant> <vector>)
file(CONFIGURE OUTPUT precompiled.cpp CONTENT "int main() {}\n")
add_library(hair_precompiled_library OBJECT "${CMAKE_CURRENT_BINARY_DIR}/precompiled.cpp")
add_executable(hair_precompiled_test EXCLUDE_FROM_ALL "${CMAKE_CURRENT_BINARY_DIR}/precompiled.cpp")
target_link_libraries(hair_precompiled_test PRIVATE GTest::gtest)
foreach(target hair_precompiled_library hair_precompiled_test)
  hair_warnings(${target})
  target_link_libraries(${target} PRIVATE Eigen3::Eigen nlohmann_json::nlohmann_json)
endforeach()
target_precompile_headers(hair_precompiled_library PRIVATE ${headers})
target_precompile_headers(hair_precompiled_test PRIVATE ${headers} <gtest/gtest.h>)

function(hair_precompile TARGET)
  get_target_property(type ${TARGET} TYPE)
  if(type MATCHES "LIBRARY$")
    target_precompile_headers(${TARGET} REUSE_FROM hair_precompiled_library)
  endif()
endfunction()

function(hair_precompile_test TARGET)
  target_precompile_headers(${TARGET} REUSE_FROM hair_precompiled_test)
endfunction()
