// STAFF ONLY. The program's operator new, which counts. In a file of its own, so that no compiler inlines one
// half of it.

#include "solver/tests/allocations.h"

#include <cstdlib>
#include <new>

namespace {
long count = 0;
}

long reference_tests::allocations() {
  return count;
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++count;
  return std::malloc(size > 0 ? size : 1);
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
