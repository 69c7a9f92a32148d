#include "solver/filled_blocks.h"

#include <cstdlib>

#if defined(__SANITIZE_ADDRESS__)
#define HAIR_OWN_MALLOC 0  // it fills blocks itself (checks/check.cpp)
#elif defined(__GLIBC__)
#define HAIR_OWN_MALLOC 1
#else
#define HAIR_OWN_MALLOC 0
#endif
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#undef HAIR_OWN_MALLOC
#define HAIR_OWN_MALLOC 0
#endif
#endif

#if HAIR_OWN_MALLOC
#include <malloc.h>

#include <cerrno>
#include <cstring>

namespace solver {
namespace {

const int kept_threshold = mallopt(M_MMAP_THRESHOLD, static_cast<int>(kMostFilled));

// Fills the whole block of the C library, which may be larger than requested: so realloc finds the end of the
// filled part.
void* filled(void* memory, std::size_t from = 0) {
  const std::size_t size = malloc_usable_size(memory);
  if (size > from && size <= kMostFilled)
    std::memset(static_cast<char*>(memory) + from, kUnsetByte, size - from);
  return memory;
}

}  // namespace
}  // namespace solver

extern "C" {

// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming): the C library's names
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)

__attribute__((visibility("default"))) void* malloc(std::size_t size) noexcept {
  return solver::filled(__libc_malloc(size));
}
__attribute__((visibility("default"))) void* calloc(std::size_t number, std::size_t size) noexcept {
  return solver::filled(__libc_calloc(number, size), number * size);
}
__attribute__((visibility("default"))) void* realloc(void* memory, std::size_t size) noexcept {
  const std::size_t before = malloc_usable_size(memory);
  return solver::filled(__libc_realloc(memory, size), before);
}
__attribute__((visibility("default"))) void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return solver::filled(__libc_memalign(alignment, size));
}
__attribute__((visibility("default"))) int posix_memalign(void** memory, std::size_t alignment,
                                                          std::size_t size) noexcept {
  void* const found = aligned_alloc(alignment, size);
  if (found == nullptr) return errno;
  *memory = found;
  return 0;
}
}
#endif
