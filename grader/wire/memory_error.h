// STAFF ONLY. A memory error, as a worker with sanitizers tells it: its kind, as a row of a table, and where the
// student's object was on the stack, as offsets in that object. So no text leaves the worker. The sender may lie
// about both: all that it can choose is a sentence of ours and lines of its own file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "grader/wire/message.h"

namespace grader {

struct MemoryErrorKind {
  std::string_view runtime;  // what the sanitizers' runtime calls it
  const char* shown;         // what the code does, for students
};

// What costs a point. The runtime reports other things, too: memory or stack used up, which are limits of ours.
std::span<const MemoryErrorKind> memory_error_kinds();

// The row of one of the runtime's names; nothing if it is none of them.
std::optional<std::uint32_t> memory_error_kind(std::string_view runtime);

inline constexpr std::size_t kMostFrames = 24;

struct MemoryError {
  std::uint32_t kind = 0;              // a row of the table
  std::vector<std::uint64_t> offsets;  // in the student's object, innermost frame first

  const char* shown() const { return memory_error_kinds()[kind].shown; }
};

// Throws MalformedMessage for a kind that is not there, or for more frames than kMostFrames.
MemoryError read_memory_error(MessageReader& body);

}  // namespace grader
