// STAFF ONLY. Tests whether this machine can isolate student code, by doing it.
#pragma once

#include <string>

#include "grader/compile/kit.h"

namespace grader {

// Empty if a caged worker starts; otherwise the reason and a remedy.
std::string why_not_isolated(const StagedKit& kit);

}  // namespace grader
