// STAFF ONLY. Whether this machine can isolate student code, found out by doing it.
#pragma once

#include <string>

#include "grader/compile/kit.h"

namespace grader {

// Empty if a caged worker starts; otherwise why it does not, and what would help.
std::string why_not_isolated(const StagedKit& kit);

}  // namespace grader
