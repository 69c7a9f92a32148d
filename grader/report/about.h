// STAFF ONLY. A student's answers to the questions of about.txt (handout/about.txt).
#pragma once

#include <optional>
#include <string>

namespace grader::inline report {

// Each is one line without blanks at its ends; "": no answer.
struct About {
  std::string hours, hardest, unclear;
  std::string handout;  // the version that the hand-in was made with: the handout's build adds it

  bool operator==(const About&) const = default;
};

// A question is a line that has its words, or the first one alone, and then a colon; its answer goes on until
// the next question. Text before the first one is no answer.
About read_about(const std::string& text);

// The first number of an answer, with a point or a comma: "about 12,5 h" is 12.5. Nothing without one, or
// beyond 1000.
std::optional<double> hours_of(const About& about);

}  // namespace grader::report
