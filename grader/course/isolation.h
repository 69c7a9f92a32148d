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

inline const char* to_string(Isolation kind) {
  constexpr const char* kNames[] = {"none", "namespaces", "container"};
  return kNames[static_cast<int>(kind)];
}
inline std::optional<Isolation> isolation_from(std::string_view word) {
  for (const Isolation kind : {Isolation::none, Isolation::namespaces, Isolation::container})
    if (word == to_string(kind)) return kind;
  return {};
}

// Returns a sentence without a full stop for every page and file of results. It is empty for namespaces.
inline const char* said_of(Isolation kind) {
  return kind == Isolation::none        ? "Graded without a sandbox"
         : kind == Isolation::container ? "Graded with a container's sandbox"
                                        : "";
}

}  // namespace grader::course
