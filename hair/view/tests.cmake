# STAFF ONLY. Builds the tests of the viewer's motions and framing.
hair_test(hair_view_test SANITISED SOURCES motion_test.cpp LIBRARIES hair_view)
add_subdirectory(browser)

# The runs are made in the release build.
if(NOT HAIR_RELEASE_BUILD)
  hair_test(framing_test SOURCES framing_test.cpp LIBRARIES hair_view)
  target_compile_definitions(framing_test PRIVATE HAIR_MOTIONS_DIR="${PROJECT_BINARY_DIR}/golden/motions")
  add_dependencies(framing_test hair_motions)
endif()
