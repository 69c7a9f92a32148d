// STAFF ONLY. Which exercise file a name means.
//
//   conj_grad.cpp                                        the file itself
//   conj_grad (1).cpp, conj_grad-1.cpp, CONJ_GRAD.CPP    a copy that browsers and systems rename: taken if it is the only one, and said
//   ConjGrad.cpp, conj_grad.txt, conj_grad_final.cc      like it: never taken, but named to student and staff
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
  std::string file;  // the exercise's
  Degree degree;
  int number = -1;  // of a copy
};

std::string in_lower_case(std::string_view text);  // ASCII's letters

// "conj_grad (1)", "conj_grad(1)", "conj_grad-1": what stands before the number, without a bracket. The name
// itself and -1 if it ends with none.
struct Numbered {
  std::string_view name;
  int number = -1;
  bool bracket = false;
};
Numbered without_number(std::string_view name);

std::optional<Likeness> exercise_file(std::string_view name, const FileNames& exercise_files);

}  // namespace grader::intake
