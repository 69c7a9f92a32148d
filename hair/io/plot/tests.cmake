# STAFF ONLY. Tests of this folder.
# libxml2 is a strict parser: all tests read pages and figures with it.
find_package(LibXml2 REQUIRED)
add_library(hair_parsed_xml STATIC EXCLUDE_FROM_ALL test_parsed.cpp)
hair_own_code(hair_parsed_xml)
target_link_libraries(hair_parsed_xml PUBLIC hair_interfaces PRIVATE LibXml2::LibXml2)
hair_test(hair_plot_test SOURCES figure_test.cpp cell_map_test.cpp html_test.cpp
          look_test.cpp page_test.cpp work_precision_test.cpp LIBRARIES hair_plot hair_parsed_xml hair_files)
