// STAFF ONLY. Describes wrong numbers by one of a few sentences for students. A number that code may choose
// could carry a hidden input out.
#pragma once

#include <string>

#include "handout/check/hint.h"

namespace grader::inline judge {

// Returns an empty text if no mistake is clear, and for a factor that no ordinary mistake makes.
std::string hint_for_students(const checks::Hint& hint);

}  // namespace grader::judge
