// STAFF ONLY. Describes the errors that sanitizers report.
#include "grader/wire/memory_error.h"

namespace grader::inline wire {
namespace {

constexpr const char* kHeap = "reaches outside of memory that it got from new or malloc";
constexpr const char* kStack = "reaches outside of an array or a variable on the stack";
constexpr const char* kAddress = "reaches to an address where there is nothing";
constexpr const char* kFrees = "frees what was not allocated, or not at its beginning";

constexpr MemoryErrorKind kKinds[] = {
    {"heap-buffer-overflow", kHeap},
    {"stack-buffer-overflow", kStack},
    {"stack-buffer-underflow", kStack},
    {"dynamic-stack-buffer-overflow", "reaches outside of an array of variable length"},
    {"global-buffer-overflow", "reaches outside of a static or global array"},
    {"use-after-poison", "reaches outside of an array that it was given"},
    {"heap-use-after-free", "uses memory that is freed already"},
    {"stack-use-after-scope", "uses a local variable whose block has ended"},
    {"unknown-crash", "reaches outside of an array or a variable"},
    {"null-deref", "follows a null pointer"},
    {"wild-addr", kAddress},
    {"wild-addr-read", kAddress},
    {"wild-addr-write", kAddress},
    {"wild-jump", "calls a function where there is none"},
    {"signal", kAddress},
    {"double-free", "frees the same memory twice"},
    {"bad-free", kFrees},
    {"alloc-dealloc-mismatch",
     "frees memory in another way than it was allocated: delete for new[], or free for new"},
    {"new-delete-type-mismatch", "deletes an object as one of another size"},
    {"memcpy-param-overlap", "copies between memory that overlaps"},
    {"negative-size-param", "copies or sets a negative number of bytes"},
    {"out-of-bounds-index", "has an index outside of its array"},
    {"signed-integer-overflow", "computes an integer that is too large for its type"},
    {"integer-divide-by-zero", "divides an integer by zero"},
    {"invalid-shift-base", "shifts an integer too far"},
    {"invalid-shift-exponent", "shifts an integer too far"},
    {"non-positive-vla-index", "has an array of variable length whose length is not positive"},
    {"missing-return", "comes to the end of a function without a return"},
};

}  // namespace

std::span<const MemoryErrorKind> memory_error_kinds() {
  return kKinds;
}

std::optional<std::uint32_t> memory_error_kind(std::string_view runtime) {
  for (std::uint32_t row = 0; row < std::size(kKinds); ++row)
    if (kKinds[row].runtime == runtime) return row;
  return {};
}

const MemoryErrorKind& read_memory_error(MessageReader& body) {
  const auto kind = body.get<std::uint32_t>();
  if (kind >= std::size(kKinds)) throw MalformedMessage("a kind of memory error that is not there");
  body.expect_end();
  return kKinds[kind];
}

}  // namespace grader::wire
