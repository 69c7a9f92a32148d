// STAFF ONLY. Writes a number for people: "2", "1.5", with at most two digits behind the point.
#pragma once

#include <cmath>
#include <string>

namespace grader::inline record {

inline std::string shown_number(double value) {
  std::string text = std::to_string(std::round(value * 100) / 100);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace grader::record
