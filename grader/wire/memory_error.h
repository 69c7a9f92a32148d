// STAFF ONLY. A memory error, as a worker with sanitizers tells it: its kind, as a row of a table. So no text
// and no place leaves the worker. The sender may lie: all that it can choose is a sentence of ours.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "grader/wire/message.h"

namespace grader::inline wire {

struct MemoryErrorKind {
  std::string_view runtime;  // what the sanitizers' runtime calls it
  const char* shown;         // what the code does, for students
};

// What costs a point. The runtime reports other things, too: memory or stack used up, which are limits of
// ours.
std::span<const MemoryErrorKind> memory_error_kinds();

// The row of one of the runtime's names; nothing if it is none of them.
std::optional<std::uint32_t> memory_error_kind(std::string_view runtime);

// Throws MalformedMessage for a kind that is not there.
const MemoryErrorKind& read_memory_error(MessageReader& body);

}  // namespace grader::wire
