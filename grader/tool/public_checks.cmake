# STAFF ONLY. Builds the public checks of a student's object, which lies in /objects of a sandbox: here they
# are only linked with one of the kit's. The program also sets where that object looks for its prerequisites
# (DT_RPATH). The second program has the sanitizers' runtime, as grader/worker/ makes it.
set(HAIR_PUBLIC_CHECKS "${CMAKE_CURRENT_BINARY_DIR}/public_checks" CACHE INTERNAL
    "The public checks' programs, for students' objects")
set(runtime)
foreach(name libasan libubsan)
  execute_process(COMMAND /usr/bin/g++ -print-file-name=${name}.so OUTPUT_VARIABLE library
                  OUTPUT_STRIP_TRAILING_WHITESPACE)
  list(APPEND runtime "${library}")
endforeach()
add_custom_target(public_checks)
foreach(id ${HAIR_EXERCISES})
  foreach(build ordinary sanitised)
    add_executable(public_checks_${build}_${id} EXCLUDE_FROM_ALL $<TARGET_OBJECTS:hair_check_${id}>)
    target_link_libraries(public_checks_${build}_${id} PRIVATE kit_${id} hair_check)
    target_link_options(public_checks_${build}_${id}
                        PRIVATE -Wl,--disable-new-dtags,-rpath,/objects:/sanitised)
    if(build STREQUAL "ordinary")
      target_link_libraries(public_checks_${build}_${id} PRIVATE hair_filled_blocks)
    else()
      target_link_options(public_checks_${build}_${id} BEFORE PRIVATE ${HAIR_FIXED_ADDRESSES}
                          -Wl,--no-as-needed ${runtime})
    endif()
    set_target_properties(public_checks_${build}_${id} PROPERTIES RUNTIME_OUTPUT_DIRECTORY
                          "${HAIR_PUBLIC_CHECKS}/${build}" OUTPUT_NAME ${id}
      SKIP_BUILD_RPATH ON)
    add_dependencies(public_checks public_checks_${build}_${id})
  endforeach()
endforeach()
