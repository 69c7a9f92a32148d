// STAFF ONLY. Counting replacements of the program's operator new and malloc: Eigen's matrices take their
// memory from malloc. A file of its own, so that no compiler inlines one half of it.

#include "solver/test_allocations.h"

#include <cstdlib>
#include <new>

namespace {
long count = 0;
}

long reference_tests::allocations() {
  return count;
}

// The linker gives calls of malloc in the program's own code to __wrap_malloc, and calls of __real_malloc to
// malloc.
// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming)
extern "C" void* __real_malloc(std::size_t size);
extern "C" void* __wrap_malloc(std::size_t size) {
  ++count;
  return __real_malloc(size);
}
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++count;
  return __real_malloc(size > 0 ? size : 1);
}
void* operator new(std::size_t size) {
  if (void* memory = operator new(size, std::nothrow)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
