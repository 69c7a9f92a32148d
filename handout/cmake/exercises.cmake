# Builds exercises from exercises.json, the one list of them.
#
#   HAIR_EXERCISES                 the ids of the course's exercises, in the file's order (staff: of all)
#   HAIR_LEFT_OUT                  the ids of the others
#   HAIR_<id>_<FIELD>              file, header, role, prerequisites, libraries, functions of each. In a
#                                  function's signature, Input, Output and Scratch (particles/vectors.h) are
#                                  spelled out as compilers do
#   HAIR_GIVEN_DIR                 the folder of the given code: solver/, particles/, hair/
#   HAIR_CONTRACT_DIRS             more folders on the include path
#   HAIR_LECTURE_DIR               one more, for students' files and the lecture's programs
#   HAIR_FIXED_ADDRESSES           how a program with AddressSanitizer is linked
#   hair_use_libraries(TARGET ID)  the libraries beside the standard one that exercise ID may include
#   HAIR_GIVEN_<LIBRARY>           the given code that a file may call if it may include LIBRARY;
#                                  HAIR_GIVEN_standard is for each file
#   hair_compile_settings(TARGET)  C++20 and the flags that results depend on, for all code
#   HAIR_FASTEST                   the flag of exercises, and of given code that takes their steps. A
#                                  precompiled header undoes it silently, if it lacks it
#   hair_warnings(TARGET)          the same and warnings, for our code, never for a student's file. They are
#                                  errors in the staff's build alone, as a student's compiler may be newer
#   hair_own_code(TARGET)          the same, and a library has the precompiled headers of libraries
#                                  (precompiled.cmake)
#   hair_fast_code(TARGET)         with HAIR_FASTEST and without a precompiled header
#   hair_exercise_libraries(NAME DIR [STUDENT] [SANITISED])
#                                  a library <NAME>_<id> for each exercise file in DIR, or in DIR/<id>.
#                                  STUDENT: compiled and linked as for grading; SANITISED: with the sanitizers
#                                  that find memory errors (checks.cmake), too
#   hair_left_out(NAME ID...)      a static library that stands for these exercises: each of their functions
#                                  throws NotInCourse

# Programs with AddressSanitizer are linked at fixed addresses. Where the kernel moves memory by 32 random
# bits (vm.mmap_rnd_bits), GCC's runtime before version 14 and clang's before 17 find no room for themselves
# in a quarter of all starts of a movable program.
set(HAIR_FIXED_ADDRESSES)
if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
  set(HAIR_FIXED_ADDRESSES -no-pie)
endif()
if("${CMAKE_CXX_FLAGS}" MATCHES "-fsanitize=[^ ]*address")
  add_link_options("$<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>:${HAIR_FIXED_ADDRESSES}>")
endif()

set(HAIR_HANDOUT_DIR "${CMAKE_CURRENT_LIST_DIR}/..")
# In the project the given code lies beside the handout. Students have contracts on top, and the rest below
# given/, so that an include line says the same in both. given/student/ is empty: by it "../hair/..." in a
# student's file finds what lies below given/.
get_filename_component(HAIR_GIVEN_DIR "${HAIR_HANDOUT_DIR}/.." ABSOLUTE)
set(HAIR_CONTRACT_DIRS)
set(HAIR_LECTURE_DIR "${HAIR_GIVEN_DIR}/solver/lecture")
if(IS_DIRECTORY "${HAIR_HANDOUT_DIR}/given")
  get_filename_component(HAIR_GIVEN_DIR "${HAIR_HANDOUT_DIR}/given" ABSOLUTE)
  get_filename_component(top "${HAIR_HANDOUT_DIR}" ABSOLUTE)
  set(HAIR_CONTRACT_DIRS "${top}" "${HAIR_GIVEN_DIR}/student")
  set(HAIR_LECTURE_DIR "${top}/solver/lecture")
endif()
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${HAIR_HANDOUT_DIR}/exercises.json")
file(READ "${HAIR_HANDOUT_DIR}/exercises.json" json)

function(hair_json_list OUT JSON FIELD)
  set(values)
  string(JSON length LENGTH "${JSON}" ${FIELD})
  if(length GREATER 0)
    math(EXPR last "${length} - 1")
    foreach(i RANGE ${last})
      string(JSON value GET "${JSON}" ${FIELD} ${i})
      list(APPEND values "${value}")
    endforeach()
  endif()
  set(${OUT} "${values}" PARENT_SCOPE)
endfunction()

string(JSON count LENGTH "${json}" exercises)
math(EXPR last "${count} - 1")
set(HAIR_EXERCISES)
set(HAIR_LEFT_OUT)
foreach(i RANGE ${last})
  string(JSON exercise GET "${json}" exercises ${i})
  string(JSON id GET "${exercise}" id)
  string(JSON HAIR_${id}_FILE GET "${exercise}" file)
  string(JSON HAIR_${id}_HEADER GET "${exercise}" header)
  string(JSON HAIR_${id}_ROLE GET "${exercise}" role)
  string(JSON HAIR_${id}_SHOW ERROR_VARIABLE HAIR_${id}_SHOWS_NOTHING GET "${exercise}" show)
  if(HAIR_${id}_ROLE STREQUAL "absent" AND NOT HAIR_STAFF)
    list(APPEND HAIR_LEFT_OUT ${id})
  else()
    list(APPEND HAIR_EXERCISES ${id})
  endif()
  hair_json_list(HAIR_${id}_PREREQUISITES "${exercise}" prerequisites)
  hair_json_list(HAIR_${id}_LIBRARIES "${exercise}" libraries)
  hair_json_list(functions "${exercise}" functions)
  set(vector "Eigen::Matrix<double, -1, 1, 0, -1, 1>")
  list(TRANSFORM functions REPLACE "Input" "Eigen::Ref<${vector} const, 0, Eigen::InnerStride<1> > const&")
  list(TRANSFORM functions REPLACE "Output" "Eigen::Ref<${vector}, 0, Eigen::InnerStride<1> >")
  list(TRANSFORM functions REPLACE "Scratch"
       "Eigen::Ref<Eigen::Matrix<double, -1, -1, 0, -1, -1>, 0, Eigen::OuterStride<-1> >")
  set(HAIR_${id}_FUNCTIONS "${functions}")
endforeach()

# -O2 does not inline the dot of two 3-vectors.
set(HAIR_FASTEST $<$<CONFIG:Release>:-O3>)

function(hair_compile_settings TARGET)
  target_compile_features(${TARGET} PUBLIC cxx_std_20)
  set_target_properties(${TARGET} PROPERTIES CXX_EXTENSIONS OFF)
  # No fused multiply-adds: results must not depend on the machine that compiles.
  target_compile_options(${TARGET} PRIVATE -ffp-contract=off $<$<CONFIG:Release>:-O2>)
endfunction()

function(hair_warnings TARGET)
  hair_compile_settings(${TARGET})
  # GCC 12 warns wrongly of overlaps and bounds in "text" + std::string (its bug 105651).
  set(wrong -Wno-restrict -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
  target_compile_options(${TARGET} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor
                         "$<$<CXX_COMPILER_ID:GNU>:${wrong}>" $<$<BOOL:${HAIR_STAFF}>:-Werror>)
  if(CMAKE_UNITY_BUILD)
    # GCC takes a source that another one includes for a header, and warns. Many sources take much memory;
    # with a larger heap GCC collects garbage less often, which took a tenth of its time.
    set(of_unity -Wno-subobject-linkage --param=ggc-min-heapsize=524288)
    target_compile_options(${TARGET} PRIVATE "$<$<CXX_COMPILER_ID:GNU>:${of_unity}>")
  endif()
endfunction()

function(hair_own_code TARGET)
  hair_warnings(${TARGET})
  get_target_property(type ${TARGET} TYPE)
  if(type MATCHES "LIBRARY$")
    hair_precompile(${TARGET} library)
  endif()
endfunction()

function(hair_fast_code TARGET)
  hair_warnings(${TARGET})
  target_compile_options(${TARGET} PRIVATE ${HAIR_FASTEST})
endfunction()

# Eigen, for the given code and for the exercises that may include it: any version from 3.3 on. The version is
# compared here, since Eigen's package refuses another first number than find_package asks for.
include("${CMAKE_CURRENT_LIST_DIR}/packages.cmake")
find_package(Eigen3 QUIET NO_MODULE)
if(NOT TARGET Eigen3::Eigen OR Eigen3_VERSION VERSION_LESS 3.3)
  hair_how_to_install(how libeigen3-dev)
  message(FATAL_ERROR "Eigen is missing, version 3.3 or later. ${how}")
endif()

set(HAIR_GIVEN_standard hair_solver)
set(HAIR_GIVEN_eigen hair_particles hair_block_bands)

function(hair_use_libraries TARGET ID)
  foreach(library ${HAIR_${ID}_LIBRARIES})
    if(library STREQUAL "eigen")
      target_link_libraries(${TARGET} PUBLIC Eigen3::Eigen)
    endif()
  endforeach()
endfunction()

# As in grading, a student's asserts and Eigen's are checked, and a variable that is never set holds the same
# in each run.
include(CheckCXXCompilerFlag)
check_cxx_compiler_flag(-ftrivial-auto-var-init=pattern HAIR_HAS_UNSET_PATTERN)
set(HAIR_STUDENT_OPTIONS -Wall -Wextra -UNDEBUG)
if(HAIR_HAS_UNSET_PATTERN)
  list(APPEND HAIR_STUDENT_OPTIONS -ftrivial-auto-var-init=pattern)
else()
  message(STATUS "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION} does not know "
                 "-ftrivial-auto-var-init=pattern, as g++ 12 and clang 8 do: a variable that is never set "
                 "may hold another value in each run, and in grading")
endif()

# As in grading, this is a shared library that exports the exercise's functions, and calls the standard
# library, the given code that it may call, its prerequisites and nothing else. A missing function is an error
# when it is linked.
function(hair_student_library TARGET ID)
  # CMake adds no definition of its own to the compiler's command line.
  set_target_properties(${TARGET} PROPERTIES DEFINE_SYMBOL "")
  if(HAIR_CONTRACT_DIRS)
    get_target_property(file ${TARGET} SOURCES)
    get_filename_component(top "${HAIR_HANDOUT_DIR}" ABSOLUTE)
    add_custom_command(TARGET ${TARGET} PRE_LINK
      COMMAND ${CMAKE_COMMAND} "-DFILE=${file}" "-DTOP=${top}" "-DLIBRARIES=${HAIR_${ID}_LIBRARIES}"
              "-DCOMPILER=${CMAKE_CXX_COMPILER}"
              "-DINCLUDES=$<TARGET_PROPERTY:${TARGET},INCLUDE_DIRECTORIES>" -P "${top}/cmake/includes.cmake"
      VERBATIM)
  endif()
  # The linker of macOS refuses missing symbols by itself, and binds each symbol to its library.
  if(CMAKE_SYSTEM_NAME STREQUAL "Darwin")
    return()
  endif()
  set(names)
  foreach(function ${HAIR_${ID}_FUNCTIONS})
    string(REGEX REPLACE "[(].*" "*;" name "${function}")
    string(APPEND names " ${name}")
  endforeach()
  # The names of types are exported, too: with them a program catches an exception that a library throws.
  set(exported "${CMAKE_CURRENT_BINARY_DIR}/${TARGET}.map")
  file(CONFIGURE OUTPUT "${exported}"
       CONTENT "{ global: extern \"C++\" {${names} }; _ZTI*; _ZTS*; local: *; };\n" @ONLY)
  # The path is relative to the linker's folder: in the names of folders above, CMake would write a $ twice.
  set(started "${CMAKE_CURRENT_BINARY_DIR}")
  if(CMAKE_GENERATOR MATCHES "Ninja")
    set(started "${CMAKE_BINARY_DIR}")
  endif()
  file(RELATIVE_PATH exported "${started}" "${exported}")
  target_link_options(${TARGET} PRIVATE "-Wl,--version-script=${exported}")
  # clang has the sanitizers' functions in programs alone.
  get_target_property(options ${TARGET} COMPILE_OPTIONS)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES "Clang" OR NOT "${options};${CMAKE_CXX_FLAGS}" MATCHES "-fsanitize=")
    target_link_options(${TARGET} PRIVATE -Wl,-z,defs)
  endif()
endfunction()

function(hair_exercise_libraries NAME DIR)
  cmake_parse_arguments(PARSE_ARGV 2 ARG "STUDENT;SANITISED" "" "")
  set(type STATIC)
  set(linked PUBLIC)
  set(kind exercise)
  if(ARG_STUDENT)
    set(type SHARED)
    set(linked PRIVATE)
    set(kind student_exercise)
  endif()
  if(ARG_SANITISED)
    set(kind sanitised_exercise)
  endif()
  foreach(id ${HAIR_EXERCISES})
    set(file "${DIR}/${id}/${HAIR_${id}_FILE}")
    if(NOT EXISTS "${file}")
      set(file "${DIR}/${HAIR_${id}_FILE}")
    endif()
    if(NOT EXISTS "${file}")
      message(FATAL_ERROR "exercise ${id}: ${file} is missing; restore it from the handout")
    endif()
    add_library(${NAME}_${id} ${type} "${file}")
    hair_compile_settings(${NAME}_${id})
    target_compile_options(${NAME}_${id} PRIVATE ${HAIR_FASTEST})
    set_target_properties(${NAME}_${id} PROPERTIES POSITION_INDEPENDENT_CODE ON UNITY_BUILD OFF)
    target_link_libraries(${NAME}_${id} PUBLIC hair_interfaces)
    target_include_directories(${NAME}_${id} PUBLIC "${HAIR_LECTURE_DIR}")
    hair_use_libraries(${NAME}_${id} ${id})
    if(ARG_SANITISED)
      hair_sanitise(${NAME}_${id})
    endif()
    if(ARG_STUDENT)
      target_compile_options(${NAME}_${id} PRIVATE ${HAIR_STUDENT_OPTIONS})
      hair_student_library(${NAME}_${id} ${id})
    endif()
    if("eigen" IN_LIST HAIR_${id}_LIBRARIES)
      hair_precompile(${NAME}_${id} ${kind})
    endif()
    foreach(library ${HAIR_${id}_LIBRARIES} standard)
      target_link_libraries(${NAME}_${id} ${linked} ${HAIR_GIVEN_${library}})
    endforeach()
  endforeach()
  foreach(id ${HAIR_EXERCISES})
    foreach(prerequisite ${HAIR_${id}_PREREQUISITES})
      target_link_libraries(${NAME}_${id} ${linked} ${NAME}_${prerequisite})
    endforeach()
  endforeach()
endfunction()

# All given code is linked in each course: these definitions stand for the exercises that the course lacks.
function(hair_left_out NAME)
  set(files)
  foreach(id ${ARGN})
    set(text "// ${id} is not in this course. Made by cmake/exercises.cmake of exercises.json.\n")
    string(APPEND text "#include \"${HAIR_${id}_HEADER}\"\n#include \"solver/not_in_course.h\"\n\n"
                       "template <class Result, class... P>\nResult result_of(Result (*)(P...));\n")
    foreach(signature ${HAIR_${id}_FUNCTIONS})
      string(REGEX REPLACE "[(].*" "" function "${signature}")
      string(REGEX REPLACE "^.*::" "" name "${function}")
      string(APPEND text "\ndecltype(result_of(&${function})) ${signature} {\n"
                         "  throw NotInCourse(\"${id} ${name}\");\n}\n")
    endforeach()
    set(file "${CMAKE_CURRENT_BINARY_DIR}/${NAME}/${HAIR_${id}_FILE}")
    file(CONFIGURE OUTPUT "${file}" CONTENT "${text}" @ONLY)
    list(APPEND files "${file}")
  endforeach()
  add_library(${NAME} STATIC EXCLUDE_FROM_ALL ${files})
  hair_compile_settings(${NAME})
  target_link_libraries(${NAME} PUBLIC hair_interfaces Eigen3::Eigen)
endfunction()
