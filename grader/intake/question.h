// STAFF ONLY. The exception for input that only a person can judge: an option confirms it.
#pragma once

#include <string>

#include "grader/course/input.h"

namespace grader::inline intake {

struct Question : BadInput {
  Question(const std::string& line, const std::string& option_that_settles_it)
      : BadInput(line + " " + option_that_settles_it), option(option_that_settles_it) {}
  std::string option;
};

inline constexpr const char *kSaysClass = "--class", *kSaysReplace = "--replace";

}  // namespace grader::intake
