// STAFF ONLY. Input that nobody but a person can judge: an option says that it is right.
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
