// STAFF ONLY. Cases of S1 that stand in files of their own.
#pragma once

#include <optional>

#include "grader/judge/linear_system.h"

namespace grader::s1 {

// How much too large the student's count of steps is everywhere, which is the step limit's subject; nothing if it counts no steps. Other
// categories take it off before they look at a count.
std::optional<int> own_offset(Trial& trial);

// Each sends its cases to the student's ConjGrad and throws CaseFailed at the first failure.
void systems(Trial& trial);
void sizes(Trial& trial);
void hard_systems(Trial& trial);
void empty(Trial& trial);
void first_guess(Trial& trial);
void step_limit(Trial& trial);
void tolerance(Trial& trial);
void return_value(Trial& trial);
void scaling(Trial& trial);
void not_positive_definite(Trial& trial);
void not_finite(Trial& trial);
void sixty_fourth(Trial& trial);
void call_after_call(Trial& trial);

}  // namespace grader::s1
