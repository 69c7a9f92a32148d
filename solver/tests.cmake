# STAFF ONLY. Tests of this folder.
# Counts allocations for tests. It is a library of its own, so that no compiler inlines one half of it.
add_library(hair_allocations STATIC EXCLUDE_FROM_ALL test_allocations.cpp)
hair_own_code(hair_allocations)
target_include_directories(hair_allocations PUBLIC "${PROJECT_SOURCE_DIR}")
target_link_options(hair_allocations INTERFACE "LINKER:--wrap=malloc")

hair_test(matrices_test SANITISED SOURCES matrices_test.cpp LIBRARIES hair_solver)
hair_test(block_cholesky_test SANITISED SOURCES block_cholesky_test.cpp LIBRARIES hair_block_bands)
