// STAFF ONLY. Catches errors of bad input, for tests.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "grader/course/input.h"

namespace grader::inline course {

// Returns the line that `act` throws as BadInput. It must be a single line.
inline std::string refusal(const std::function<void()>& act) {
  try {
    act();
  } catch (const BadInput& line) {
    EXPECT_EQ(std::string(line.what()).find('\n'), std::string::npos) << line.what();
    return line.what();
  }
  return "nothing is refused";
}

}  // namespace grader::course
