// STAFF ONLY. The worker's malloc, which counts where it is asked to (session.h), fills what it gives, and leaves the rest to the C
// library. So `new`, the standard library's containers and Eigen's matrices are counted and filled, of all objects that are loaded.
//
// A wrong answer that depends on memory that nobody sets is the same whenever it is graded: the C library would leave in it what was
// there before, addresses among it, which differ from run to run.
#include <malloc.h>

#include <cerrno>
#include <cstddef>
#include <cstring>

#include "grader/worker/request.h"

namespace grader {
namespace {

constinit Allocations counted;

void count() {
  if (counted.counting.load(std::memory_order_relaxed)) counted.count.fetch_add(1, std::memory_order_relaxed);
}

// As a student's variables hold that nobody sets (toolchain.cpp).
constexpr int kUnset = 0xfe;

// Larger blocks come fresh from the kernel, and hold zeros in each run: to fill them would take the time of those who only reserve.
constexpr std::size_t kMostFilled = 1 << 20;
const int kept_threshold = mallopt(M_MMAP_THRESHOLD, static_cast<int>(kMostFilled));

// With all that the C library gives, which may be more than was asked for: so realloc finds where it was filled to.
void* filled(void* memory, std::size_t from = 0) {
  const std::size_t size = malloc_usable_size(memory);
  if (size > from && size <= kMostFilled) std::memset(static_cast<char*>(memory) + from, kUnset, size - from);
  return memory;
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
  return grader::filled(__libc_malloc(size));
}
__attribute__((visibility("default"))) void* calloc(std::size_t number, std::size_t size) noexcept {
  grader::count();
  return grader::filled(__libc_calloc(number, size), number * size);
}
__attribute__((visibility("default"))) void* realloc(void* memory, std::size_t size) noexcept {
  grader::count();
  const std::size_t before = malloc_usable_size(memory);
  return grader::filled(__libc_realloc(memory, size), before);
}
__attribute__((visibility("default"))) void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  grader::count();
  return grader::filled(__libc_memalign(alignment, size));
}
__attribute__((visibility("default"))) int posix_memalign(void** memory, std::size_t alignment,
                                                          std::size_t size) noexcept {
  void* const found = aligned_alloc(alignment, size);
  if (found == nullptr) return errno;
  *memory = found;
  return 0;
}
}
