// STAFF ONLY. What several categories of S1 take from the step limit's.
#pragma once

#include <optional>

#include "grader/judge/linear_system.h"

namespace grader::s1 {

// How much too large the student's count of steps is everywhere, which is the step limit's subject; nothing
// if it counts no steps. Other categories take it off before they look at a count.
std::optional<int> own_offset(Trial& trial);

}  // namespace grader::s1
