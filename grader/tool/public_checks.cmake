# STAFF ONLY. Builds the public checks of a student's object, which lies in /objects of a sandbox: here they
# are only linked with one of the kit's. The program also sets where that object looks for its prerequisites
# (DT_RPATH).
set(HAIR_PUBLIC_CHECKS "${CMAKE_CURRENT_BINARY_DIR}/public_checks" CACHE INTERNAL
    "The public checks' programs, for students' objects")
add_custom_target(public_checks)
foreach(id ${HAIR_EXERCISES})
  add_executable(public_checks_${id} EXCLUDE_FROM_ALL $<TARGET_OBJECTS:hair_check_${id}>)
  target_link_libraries(public_checks_${id} PRIVATE kit_${id} hair_check hair_filled_blocks)
  target_link_options(public_checks_${id} PRIVATE -Wl,--disable-new-dtags,-rpath,/objects)
  set_target_properties(public_checks_${id} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${HAIR_PUBLIC_CHECKS}"
                        OUTPUT_NAME ${id} SKIP_BUILD_RPATH ON)
  add_dependencies(public_checks public_checks_${id})
endforeach()
