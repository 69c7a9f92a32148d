// STAFF ONLY. Divides a C++ source into words and signs, for mutants: it skips comments, texts in quotes, and
// lines of the preprocessor.
#pragma once

#include <string>
#include <vector>

namespace grader::inline mutants {

struct Word {
  enum class Kind { name, number, sign };
  Kind kind;
  std::string text;
  std::size_t at;  // is its first byte in the source
};

std::vector<Word> words_of(const std::string& source);

}  // namespace grader::mutants
