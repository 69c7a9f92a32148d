// STAFF ONLY. The kinds of isolation: how a sandbox keeps a process away from all else.
#pragma once

#include <optional>
#include <string_view>

namespace grader::inline course {

enum class Isolation {
  // Nothing does, for machines that can't and for --unsafe-no-sandbox. Paths inside are replaced by those
  // outside.
  none,
  // Namespaces of the kernel's, made by bubblewrap. Any user may, where the machine allows it.
  namespaces,
  // A user and a root folder of its own, for root in a container, where no namespaces are made and nothing is
  // mounted.
  container,
};

const char* to_string(Isolation kind);  // "none", "namespaces", "container"
std::optional<Isolation> isolation_from(std::string_view word);

// Every page and file of results says this of it, without a full stop. Of namespaces none says anything.
const char* said_of(Isolation kind);

}  // namespace grader::course
