// STAFF ONLY. Finds the exercise file that a name means:
// - conj_grad.cpp is the file itself.
// - conj_grad (1).cpp, conj_grad-1.cpp, CONJ_GRAD.CPP are copies: taken and reported if there is one only.
// - ConjGrad.cpp, conj_grad.txt, conj_grad_final.cc look like it: never taken, but reported to both sides.
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace grader::inline intake {

using FileNames = std::set<std::string, std::less<>>;

struct Likeness {
  enum class Degree { itself, renamed, like };
  std::string file;  // is the exercise's file
  Degree degree;
  int number = -1;  // is the number of a copy
};

std::string in_lower_case(std::string_view text);  // changes ASCII's letters

// Splits "conj_grad (1)", "conj_grad(1)", "conj_grad-1" into the name and its number, without brackets. A
// name without a number gets -1.
struct Numbered {
  std::string_view name;
  int number = -1;
  bool bracket = false;
};
Numbered without_number(std::string_view name);

std::optional<Likeness> exercise_file(std::string_view name, const FileNames& exercise_files);

}  // namespace grader::intake
