// STAFF ONLY. The worker's malloc, which counts where it is asked to (session.h), and leaves the rest to the C library. So
// `new`, the standard library's containers and Eigen's matrices are counted, of all objects that are loaded.
#include <cstddef>

#include "grader/worker/request.h"

namespace grader {
namespace {

constinit Allocations counted;

void count() {
  if (counted.counting.load(std::memory_order_relaxed)) counted.count.fetch_add(1, std::memory_order_relaxed);
}

}  // namespace

Allocations& allocations() {
  return counted;
}

}  // namespace grader

extern "C" {

// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming): the C library's names
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)

__attribute__((visibility("default"))) void* malloc(std::size_t size) noexcept {
  grader::count();
  return __libc_malloc(size);
}
__attribute__((visibility("default"))) void* calloc(std::size_t number, std::size_t size) noexcept {
  grader::count();
  return __libc_calloc(number, size);
}
__attribute__((visibility("default"))) void* realloc(void* memory, std::size_t size) noexcept {
  grader::count();
  return __libc_realloc(memory, size);
}
__attribute__((visibility("default"))) void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  grader::count();
  return __libc_memalign(alignment, size);
}
}
