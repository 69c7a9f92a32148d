# Run by the build when a student's file is compiled, and before it is linked: in grading a file is compiled
# with the headers of this handout, the standard library, and Eigen if its exercise may include it. A file
# that reads another one here would not compile there.
#
#   cmake -DFILE=... -DTOP=... -DLIBRARIES=... -DCOMPILER=... -DINCLUDES=... -P includes.cmake
#
# Most lines name a header that is there, and need no more. For the others it asks the compiler, which may
# skip them because they are meant for another system.
cmake_minimum_required(VERSION 3.22)
set(there "[A-Za-z_0-9]+([.]h)?|([.][.]/)?(given/)?(solver|particles|hair)/.*[.]h")
string(APPEND there "|(asm|bits|debug|experimental|ext|linux|net|netinet|parallel|pstl|sys|tr1|tr2)/.*")
set(others "the headers of this handout")
if("eigen" IN_LIST LIBRARIES)
  string(APPEND there "|(Eigen|eigen3|unsupported)/.*")
  string(APPEND others ", Eigen")
endif()
get_filename_component(folder "${FILE}" DIRECTORY)

# Says if a file of this name lies beside the student's file or in the handout.
function(is_beside OUT NAME)
  set(${OUT} OFF PARENT_SCOPE)
  foreach(base "${folder}" "${TOP}" "${TOP}/given" "${TOP}/given/student")
    if(EXISTS "${base}/${NAME}" AND NOT IS_DIRECTORY "${base}/${NAME}")
      set(${OUT} ON PARENT_SCOPE)
    endif()
  endforeach()
endfunction()

file(READ "${FILE}" text)
string(PREPEND text "\n")
string(REGEX MATCHALL "\n[ \t]*#[ \t]*include[ \t]*[<\"][^>\"\n]+" lines "${text}")
set(read)
foreach(line IN LISTS lines)
  string(REGEX REPLACE "^[^<\"]*[<\"]" "" name "${line}")
  cmake_path(NORMAL_PATH name OUTPUT_VARIABLE normal)
  set(beside OFF)
  if(NOT normal MATCHES "/")
    is_beside(beside "${normal}")
  endif()
  if(normal MATCHES "^(${there})$" AND NOT beside)
    continue()
  endif()
  if(NOT read)
    list(TRANSFORM INCLUDES PREPEND "-I" OUTPUT_VARIABLE options)
    execute_process(COMMAND "${COMPILER}" ${options} -std=c++20 -M "${FILE}" OUTPUT_VARIABLE read ERROR_QUIET)
    string(REPLACE "\n" " " read "${read}")
  endif()
  set(is_read OFF)
  foreach(base "${folder}" ${INCLUDES} /usr/include /usr/local/include /opt/homebrew/include)
    # The path as a rule of make spells it.
    string(REGEX REPLACE "([ #])" "\\\\\\1" path "${base}/${name}")
    string(REPLACE "$" "$$" path "${path}")
    string(FIND "${read}" " ${path} " at)
    if(NOT at EQUAL -1)
      set(is_read ON)
    endif()
  endforeach()
  if(is_read)
    string(FIND "${text}" "${line}" begin)
    string(SUBSTRING "${text}" 0 ${begin} above)
    string(REGEX MATCHALL "\n" above "${above}")
    list(LENGTH above number)
    math(EXPR number "${number} + 1")
    message("${FILE}:${number}: fatal error: ${name}: No such file or directory in grading, where a file is "
            "compiled with ${others} and the standard library alone")
    message(FATAL_ERROR "${FILE} includes what is not there in grading")
  endif()
endforeach()
