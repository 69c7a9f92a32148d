// STAFF ONLY. The sentences about typical mistakes in numbers, for students.
#include "grader/judge/cases/hint_for_students.h"

#include <cmath>
#include <utility>

namespace grader::inline judge {
namespace {

constexpr std::pair<double, const char*> kFactors[] = {{-1, "-1"},       {2, "2"},       {1.0 / 2, "1/2"},
                                                       {-2, "-2"},       {-0.5, "-1/2"}, {3, "3"},
                                                       {1.0 / 3, "1/3"}, {4, "4"},       {1.0 / 4, "1/4"}};

std::string told_of(double factor) {
  for (const auto& [value, text] : kFactors)
    if (std::abs(factor - value) <= 1e-6 * std::abs(value))
      return "Its numbers are " + std::string(text) + " times what is expected: a " +
             (value < 0 ? "sign?" : "factor?");
  return "";
}

}  // namespace

std::string hint_for_students(const checks::Hint& hint) {
  switch (hint.looks) {
    case checks::Looks::like_nothing:
      return "";
    case checks::Looks::never_set:
      return "One of its numbers was never set.";
    case checks::Looks::huge:
      return "One of its numbers is huge: was it made from a variable that was never set, or read beyond an "
             "end?";
    case checks::Looks::tiny:
      return "One of its numbers is tiny: was it made from a variable that was never set, or read beyond an "
             "end?";
    case checks::Looks::no_number:
      return "One of its numbers is no number: 0/0, a division by 0, or the root of a negative one?";
    case checks::Looks::zero:
      return "All of it is 0: never written, left out by a condition or a loop's bounds, or terms that "
             "cancel?";
    case checks::Looks::unchanged:
    case checks::Looks::filled:
      return "It is an input, or what stood there before the call, unchanged: never written, or nothing "
             "done?";
    case checks::Looks::wrong_at_the_end:
      return "It is right but for its last entries: a loop's bound?";
    case checks::Looks::wrong_at_the_beginning:
      return "It is right but for its first entries: a loop's bound?";
    case checks::Looks::a_factor:
      return told_of(hint.number);
    case checks::Looks::transposed:
      return "A matrix is the transpose of what is expected.";
    case checks::Looks::wrong_signs:
      return "It is right but for signs of some entries.";
  }
  return "";
}

}  // namespace grader::judge
