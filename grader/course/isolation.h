// STAFF ONLY. The kinds of isolation: the ways in which a sandbox keeps a process in.
#pragma once

#include <optional>
#include <string_view>

namespace grader::inline course {

enum class Isolation {
  // Isolates nothing, for machines that can't and for --unsafe-no-sandbox. Paths inside are replaced by those
  // outside.
  none,
  // Uses the kernel's namespaces, made by bubblewrap. Any user may do so, if the machine allows it.
  namespaces,
  // Uses a user and a root folder of its own, for root in a container, where namespaces and mounts are
  // forbidden.
  container,
};

const char* to_string(Isolation kind);  // "none", "namespaces", "container"
std::optional<Isolation> isolation_from(std::string_view word);

// Returns a sentence without a full stop for every page and file of results. It is empty for namespaces.
const char* said_of(Isolation kind);

}  // namespace grader::course
