// STAFF ONLY. Names of the kinds of isolation.
#include "grader/course/isolation.h"

namespace grader {

constexpr Isolation kAll[] = {Isolation::none, Isolation::namespaces, Isolation::container};

const char* to_string(Isolation kind) {
  switch (kind) {
    case Isolation::none:
      return "none";
    case Isolation::namespaces:
      return "namespaces";
    case Isolation::container:
      return "container";
  }
  return "";
}

const char* said_of(Isolation kind) {
  switch (kind) {
    case Isolation::none:
      return "Graded without a sandbox";
    case Isolation::namespaces:
      return "";
    case Isolation::container:
      return "Graded with a container's sandbox";
  }
  return "";
}

std::optional<Isolation> isolation_from(std::string_view word) {
  for (const Isolation kind : kAll)
    if (word == to_string(kind)) return kind;
  return {};
}

}  // namespace grader
