# STAFF ONLY. Installs the project below /usr, and makes a Debian package of it:
# `cmake --preset package && cmake --build --preset package`.
#
#   /usr/bin/                     hairlab and hairgrade start programs of the following folders
#   /usr/lib/hairlab/             for everybody: hairlab with unwritten exercises, scenes, motions
#   /usr/lib/hairgrade/build/     for the group hairgrade: hairgrade and all that it starts, golden data, a
#                                 hairlab with the reference solution
#   /usr/lib/hairgrade/source/    for this group: the project, of which hairgrade packs the handout
set(CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
                                                WORLD_READ WORLD_EXECUTE)
set(plain OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
set(debian "${PROJECT_SOURCE_DIR}/grader/package/debian")
set(grades lib/hairgrade)

# The programs look for files of a build and of the sources in these folders below the prefix.
function(hair_looks_in BUILD SOURCE)
  foreach(target ${ARGN})
    get_target_property(places ${target} COMPILE_DEFINITIONS)
    foreach(program hairsuite hairstudy)
      get_target_property(folder ${program} BINARY_DIR)
      string(REPLACE "$<TARGET_FILE:${program}>" "${folder}/${program}" places "${places}")
    endforeach()
    string(REPLACE "${PROJECT_BINARY_DIR}" "${CMAKE_INSTALL_PREFIX}/${BUILD}" places "${places}")
    string(REPLACE "${PROJECT_SOURCE_DIR}" "${CMAKE_INSTALL_PREFIX}/${SOURCE}" places "${places}")
    set_target_properties(${target} PROPERTIES COMPILE_DEFINITIONS "${places}")
  endforeach()
endfunction()
hair_looks_in(${grades}/build ${grades}/source hairgrade)
hair_looks_in(lib/hairlab lib/hairlab hair_lab hair_lab_main hair_grooms_main hair_shows_main
              hair_studies_main hair_live_main)

# For the group.
set(labs "" _shows _studies _grooms _live)
list(TRANSFORM labs PREPEND hairlab OUTPUT_VARIABLE solved)
foreach(program hairgrade hairintake hairsuite hairstudy ${solved})
  get_target_property(folder ${program} RUNTIME_OUTPUT_DIRECTORY)
  if(NOT folder)
    get_target_property(folder ${program} BINARY_DIR)
  endif()
  file(RELATIVE_PATH folder "${PROJECT_BINARY_DIR}" "${folder}")
  install(PROGRAMS $<TARGET_FILE:${program}> DESTINATION ${grades}/build/${folder})
endforeach()
foreach(folder "${HAIR_KIT_DIR}" "${HAIR_RUNNERS}" "${HAIR_HIDDEN_SCENES}" "${HAIR_GOLDEN_DIR}")
  file(RELATIVE_PATH below "${PROJECT_BINARY_DIR}" "${folder}")
  install(DIRECTORY "${folder}/" DESTINATION ${grades}/build/${below} USE_SOURCE_PERMISSIONS
          PATTERN "*.so*" PERMISSIONS ${plain})
endforeach()
install(FILES ../CMakeLists.txt ../CMakePresets.json DESTINATION ${grades}/source)
install(DIRECTORY ../solver ../particles ../hair ../handout ../reference ../grader
        DESTINATION ${grades}/source USE_SOURCE_PERMISSIONS PATTERN ".git*" EXCLUDE
        PATTERN "__pycache__" EXCLUDE)

# For everybody.
list(TRANSFORM labs PREPEND student_hairlab OUTPUT_VARIABLE unsolved)
list(TRANSFORM HAIR_EXERCISES PREPEND student_ OUTPUT_VARIABLE stubs)
set_target_properties(${unsolved} ${stubs} PROPERTIES INSTALL_RPATH "$ORIGIN")
install(TARGETS ${stubs} ${unsolved} RUNTIME DESTINATION lib/hairlab/build
        LIBRARY DESTINATION lib/hairlab/build PERMISSIONS ${plain})
install(FILES "${debian}/overrides" DESTINATION share/lintian/overrides RENAME hairgrade)
install(FILES ../handout/exercises.json DESTINATION lib/hairlab/handout)
install(DIRECTORY ../hair/scenes DESTINATION lib/hairlab/hair FILES_MATCHING PATTERN "*.json")
install(DIRECTORY "${HAIR_GOLDEN_DIR}/motions" DESTINATION lib/hairlab/golden)
install(PROGRAMS "${debian}/hairgrade" "${debian}/hairlab" DESTINATION bin)

# A later commit is a later version, which apt installs in place of this one.
set(of_commit)
if(EXISTS "${PROJECT_SOURCE_DIR}/.git/logs/HEAD")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/.git/logs/HEAD")
  execute_process(COMMAND ${CMAKE_COMMAND} -E env TZ=UTC git -C "${PROJECT_SOURCE_DIR}" show -s
                          --date=format-local:+git%Y%m%d%H%M%S --format=%cd
                  OUTPUT_VARIABLE of_commit OUTPUT_STRIP_TRAILING_WHITESPACE)
endif()
if(NOT of_commit)
  message(WARNING "No commit is known here: the package's version is ${PROJECT_VERSION}, the oldest")
endif()
set(version "${PROJECT_VERSION}${of_commit}")

# Manuals are the programs' own help.
find_program(HELP2MAN help2man REQUIRED)
set(manuals)
foreach(program hairgrade hairlab)
  set(manual "${CMAKE_CURRENT_BINARY_DIR}/${program}.1.gz")
  add_custom_command(OUTPUT "${manual}" DEPENDS ${program}
    COMMAND sh "${debian}/manual.sh" $<TARGET_FILE:${program}> "${version}" "${manual}" VERBATIM)
  list(APPEND manuals "${manual}")
endforeach()
file(CONFIGURE OUTPUT changelog CONTENT "hairgrade (${version}) unstable; urgency=low

  * The first package.

 -- Course staff <staff@hairgrade.invalid>  Sun, 29 Nov 2026 00:00:00 +0000
")
add_custom_command(OUTPUT changelog.gz COMMAND gzip -9nc changelog > changelog.gz DEPENDS changelog VERBATIM)
file(CONFIGURE OUTPUT copyright CONTENT
"Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: hairgrade

Files: *
Copyright: 2026 The authors of hairgrade
License: none
 The owner has not chosen a licence yet. All rights are reserved.
")
install(FILES ${manuals} DESTINATION share/man/man1)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/copyright" "${CMAKE_CURRENT_BINARY_DIR}/changelog.gz"
        DESTINATION share/doc/hairgrade)
add_custom_target(packaged ALL DEPENDS ${manuals} changelog.gz hairgrade_parts hairstudy hair_golden
                  hair_motions ${solved} ${unsolved})

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME hairgrade)
set(CPACK_PACKAGE_VERSION ${version})
set(CPACK_PACKAGE_CONTACT "Course staff <staff@hairgrade.invalid>")
set(CPACK_PACKAGING_INSTALL_PREFIX ${CMAKE_INSTALL_PREFIX})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "course assignment on hair simulation, and its autograder")
set(CPACK_PACKAGE_DESCRIPTION "hairlab runs scenes of hair. hairgrade packs the handout, grades hand-ins\n\
 in a sandbox and keeps a class's record; the group hairgrade runs it.")
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_FILE_NAME hairgrade_${CMAKE_SYSTEM_PROCESSOR}.deb)  # replaces an earlier version's
set(CPACK_DEBIAN_PACKAGE_SECTION education)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_PREDEPENDS adduser)
# hairgrade starts these, or loads them later.
set(CPACK_DEBIAN_PACKAGE_DEPENDS "g++ (>= 4:12), libeigen3-dev, libosmesa6, bubblewrap, similarity-tester")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS 
    "ffmpeg, nodejs, katex, node-marked, fonts-lmodern, fonttools, python3-brotli")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA "${debian}/preinst;${debian}/postrm")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)
