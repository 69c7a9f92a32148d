# Builds the public checks, and hands in.
#
#   hair_checks(NAME [LIBRARIES])
#                       one GoogleTest program <NAME>_<id>_check for each exercise, linked with the library
#                       <LIBRARIES>_<id> (<NAME>_<id> without LIBRARIES)
#   hair_sanitise(TARGET)
#                       compiles TARGET, and links the programs that use it, with the sanitizers that find
#                       memory errors, if HAIR_SANITIZED_CHECKS is on
#   HAIR_CHECKED_DIR    the folder of the checks' results, for the target `handin`
#   hair_handin(DIR)    the target `handin`: the exercise files of DIR that are not given, and about.txt, in
#                       <build>/handin.zip

include("${CMAKE_CURRENT_LIST_DIR}/categories.cmake")
find_package(GTest QUIET)
if(NOT GTest_FOUND)
  hair_how_to_install(how libgtest-dev)
  message(FATAL_ERROR "GoogleTest is missing. ${how}")
endif()

# The sanitizers stop a check at the first memory error, and say where it is; grading does without them. They
# cost some seconds of compiling, and the checks stay quick. The staff's builds choose for themselves.
set(sanitised ON)
if(HAIR_STAFF)
  set(sanitised OFF)
endif()
option(HAIR_SANITIZED_CHECKS "Build your files for the checks with sanitizers, which find memory errors"
       ${sanitised})
set(HAIR_SANITIZERS
    -fsanitize=address,signed-integer-overflow,bounds,integer-divide-by-zero,shift,vla-bound,return)
if(HAIR_SANITIZED_CHECKS)
  include(CheckCXXSourceCompiles)
  list(JOIN HAIR_SANITIZERS " " CMAKE_REQUIRED_FLAGS)
  check_cxx_source_compiles("int main() { return 0; }" HAIR_HAS_SANITIZERS)
  unset(CMAKE_REQUIRED_FLAGS)
  if(NOT HAIR_HAS_SANITIZERS)
    message(STATUS "This compiler comes without sanitizers: the checks find fewer memory errors")
  endif()
endif()

# The checks themselves are compiled without sanitizers, as the code around your files is in grading, and with
# less optimisation.
function(hair_check_code TARGET)
  hair_warnings(${TARGET})
  target_compile_options(${TARGET} PRIVATE $<$<CONFIG:Release>:-O1>)
  hair_precompile(${TARGET} check)
endfunction()
if(NOT TARGET hair_precompiled_check)
  hair_precompiled(check HEADERS <gtest/gtest.h> <Eigen/Core> <Eigen/Geometry> <algorithm> <array> <cmath>
                                 <functional> <memory> <numbers> <sstream> <string> <vector>
                   LIBRARIES hair_interfaces Eigen3::Eigen GTest::gtest)
  if(HAIR_PRECOMPILED)
    target_compile_options(hair_precompiled_check PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
endif()

# Without the macro __SANITIZE_ADDRESS__ Eigen allocates here as in code without sanitizers, so that each may
# free the other's memory.
function(hair_sanitise TARGET)
  if(HAIR_SANITIZED_CHECKS AND HAIR_HAS_SANITIZERS)
    # GCC compiles calls for checks faster than the checks themselves.
    target_compile_options(
      ${TARGET} PRIVATE -O1 -g1 -fno-omit-frame-pointer ${HAIR_SANITIZERS} -fno-sanitize-recover=all
                        -U__SANITIZE_ADDRESS__
                        $<$<CXX_COMPILER_ID:GNU>:--param=asan-instrumentation-with-call-threshold=0>)
    target_link_options(${TARGET} PUBLIC ${HAIR_SANITIZERS})
    target_link_options(${TARGET} INTERFACE
                        "$<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>:${HAIR_FIXED_ADDRESSES}>")
  endif()
endfunction()

# The data that the checks compare with: the staff's build makes it and sets its folder; the handout ships it.
if(NOT TARGET hair_golden)
  set(HAIR_GOLDEN_DIR "${HAIR_HANDOUT_DIR}/check/golden")
endif()

if(NOT TARGET hair_check)
  set(shared apart.cpp check.cpp derivative.cpp digest.cpp hint.cpp)
  list(TRANSFORM shared PREPEND "${HAIR_HANDOUT_DIR}/check/")
  add_library(hair_check STATIC ${shared})
  hair_check_code(hair_check)
  target_include_directories(hair_check PUBLIC "${HAIR_HANDOUT_DIR}/check")
  target_compile_definitions(hair_check PRIVATE "HAIR_GOLDEN_DIR=\"${HAIR_GOLDEN_DIR}\"")
  target_link_libraries(hair_check PUBLIC hair_particles hair_solver GTest::gtest)
endif()

function(hair_checks NAME)
  set(libraries ${NAME})
  if(ARGC GREATER 1)
    set(libraries ${ARGV1})
  endif()
  foreach(id ${HAIR_EXERCISES})
    # The checks are compiled once for all solutions.
    if(NOT TARGET hair_check_${id})
      add_library(hair_check_${id} OBJECT "${HAIR_HANDOUT_DIR}/exercises/${id}/check.cpp")
      hair_check_code(hair_check_${id})
      target_link_libraries(hair_check_${id} PRIVATE hair_check)
      hair_use_libraries(hair_check_${id} ${id})
      hair_categories(categories ${id})
      target_compile_definitions(hair_check_${id} PRIVATE "HAIR_EXERCISE_ID=\"${id}\""
                                                          "HAIR_CATEGORIES=\"${categories}\"")
    endif()
    hair_check_program(${NAME}_${id}_check ${libraries}_${id} ${id} ${libraries})
  endforeach()
endfunction()

# The checks of exercise ID, linked with the library EXERCISE and its prerequisites, <OTHERS>_<id>.
function(hair_check_program PROGRAM EXERCISE ID OTHERS)
  add_executable(${PROGRAM} $<TARGET_OBJECTS:hair_check_${ID}>)
  target_link_libraries(${PROGRAM} PRIVATE ${EXERCISE})
  foreach(prerequisite ${HAIR_${ID}_PREREQUISITES})
    target_link_libraries(${PROGRAM} PRIVATE ${OTHERS}_${prerequisite})
  endforeach()
  target_link_libraries(${PROGRAM} PRIVATE hair_check)
  if(NOT HAIR_SANITIZED_CHECKS OR NOT HAIR_HAS_SANITIZERS)
    target_link_libraries(${PROGRAM} PRIVATE hair_filled_blocks)
  endif()
  if(TARGET hair_golden)
    add_dependencies(${PROGRAM} hair_golden)
  endif()
endfunction()

set(HAIR_CHECKED_DIR "${PROJECT_BINARY_DIR}/checked")
file(MAKE_DIRECTORY "${HAIR_CHECKED_DIR}")
function(hair_handin DIR)
  set(STUDENT "handin" CACHE STRING "The name of the archive that the target handin writes")
  if(NOT STUDENT MATCHES "^[A-Za-z0-9][A-Za-z0-9._-]*$")
    message(FATAL_ERROR "STUDENT is \"${STUDENT}\"; it may hold letters, digits, '.', '_' and '-', "
                        "and names the archive")
  endif()
  set(exercises)
  foreach(id ${HAIR_EXERCISES})
    if(NOT HAIR_${id}_ROLE STREQUAL "given")
      list(APPEND exercises "${id}=${HAIR_${id}_FILE}")
    endif()
  endforeach()
  if(NOT exercises)
    return()
  endif()
  list(JOIN exercises "," exercises)
  add_custom_target(handin
    COMMAND ${CMAKE_COMMAND} "-DSTUDENT_DIR=${DIR}" "-DEXERCISES=${exercises}"
            "-DARCHIVE=${PROJECT_BINARY_DIR}/${STUDENT}.zip" "-DCHECKED=${HAIR_CHECKED_DIR}"
            "-DVERSION_FILE=${HAIR_HANDOUT_DIR}/version.txt" -P "${HAIR_HANDOUT_DIR}/cmake/handin.cmake"
    VERBATIM)
endfunction()
