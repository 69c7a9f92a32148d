// STAFF ONLY. Puts what wrong numbers look like into one of a few sentences for students. A number that code
// may choose could carry a hidden input out.
#pragma once

#include <string>

#include "handout/check/hint.h"

namespace grader::inline judge {

// Empty where nothing is clear, and for a factor that no ordinary mistake makes.
std::string hint_for_students(const checks::Hint& hint);

}  // namespace grader::judge
