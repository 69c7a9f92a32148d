// STAFF ONLY. A student's answers to the questions of about.txt (handout/about.txt).
#pragma once

#include <optional>
#include <string>

namespace grader::inline report {

// Holds one line for each question, without blanks at its ends; "": no answer.
struct About {
  std::string hours, hardest, unclear;
  std::string handout;  // is the handout's version, which its build adds to the hand-in

  bool operator==(const About&) const = default;
};

// Finds answers: a question is a line with its words, or the first one alone, and then a colon; its answer
// goes on until the next question. Text before the first question is no answer.
About read_about(const std::string& text);

// Returns the first number of an answer, with a point or a comma: "about 12,5 h" is 12.5. Nothing without a
// number, or beyond 1000.
std::optional<double> hours_of(const About& about);

}  // namespace grader::report
