// STAFF ONLY. A C++ source as its words and signs, for mutants: no comments, no text in quotes, no lines of
// the preprocessor.
#pragma once

#include <string>
#include <vector>

namespace grader::inline mutants {

struct Word {
  enum class Kind { name, number, sign };
  Kind kind;
  std::string text;
  std::size_t at;  // its first byte in the source
};

std::vector<Word> words_of(const std::string& source);

}  // namespace grader::mutants
