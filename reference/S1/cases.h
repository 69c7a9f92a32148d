// STAFF ONLY. The step limit's measurement that other categories of S1 use, too.
#pragma once

#include <optional>

#include "grader/judge/cases/linear_system.h"

namespace grader::s1 {

// The number by which the student's counts of steps are always too large; nothing if it counts no steps. Only
// the step limit's category is about it: the others subtract it from a count.
std::optional<int> own_offset(Trial& trial);

// True if the student's first guess is b. Only the first guess's category is about it: where it is another
// one, the others don't ask what follows from b.
bool starts_at_b(Trial& trial);

}  // namespace grader::s1
