// STAFF ONLY. Names the kinds of isolation.
#include "grader/course/isolation.h"

namespace grader::inline course {
namespace {

struct Words {
  const char *name, *said;
};

constexpr Words kWords[] = {{"none", "Graded without a sandbox"},
                            {"namespaces", ""},
                            {"container", "Graded with a container's sandbox"}};

}  // namespace

const char* to_string(Isolation kind) {
  return kWords[static_cast<int>(kind)].name;
}

const char* said_of(Isolation kind) {
  return kWords[static_cast<int>(kind)].said;
}

std::optional<Isolation> isolation_from(std::string_view word) {
  for (const Isolation kind : {Isolation::none, Isolation::namespaces, Isolation::container})
    if (word == to_string(kind)) return kind;
  return {};
}

}  // namespace grader::course
