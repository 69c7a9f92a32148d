// STAFF ONLY. Looks for words in a gradebook's lines, for tests.
#pragma once

#include <algorithm>
#include <string>

#include "grader/gradebook/grade.h"

namespace grader::inline gradebook {

inline bool says(const Gradebook& book, const std::string& words) {
  return std::ranges::any_of(book.said,
                             [&](const std::string& line) { return line.find(words) != std::string::npos; });
}

}  // namespace grader::gradebook
