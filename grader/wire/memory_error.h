// STAFF ONLY. A memory error, as a worker with sanitizers reports it: its kind, as a row of a table. So no
// text and no place leaves the worker. The sender may lie, but can only choose one of our sentences.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "grader/wire/message.h"

namespace grader::inline wire {

struct MemoryErrorKind {
  std::string_view runtime;  // is the name in the sanitizers' runtime
  const char* shown;         // describes the fault to students
};

// Lists the errors that cost a point. The runtime reports other things, too: memory or stack used up, which
// are limits of ours.
std::span<const MemoryErrorKind> memory_error_kinds();

// Returns the row of one of the runtime's names; nothing for any other name.
std::optional<std::uint32_t> memory_error_kind(std::string_view runtime);

// Throws MalformedMessage for an unknown kind.
const MemoryErrorKind& read_memory_error(MessageReader& body);

}  // namespace grader::wire
