// STAFF ONLY. Decisions of people about a student's results. They stand beside what was computed and never
// replace it, so they survive each regrade, and can be taken back.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grader/result/result.h"

namespace grader::inline record {

// A place in a result is an exercise, "H2", or a category of it, "H2.3"; "" is the whole.
enum class DecisionKind { points, excuse, comment, late_days };

std::string to_string(DecisionKind kind);  // "points", "excuse", "comment", "late-days"
std::optional<DecisionKind> decision_kind_from(const std::string& word);

struct Decision {
  DecisionKind kind = DecisionKind::points;
  std::string place;
  double number = 0;     // points, or days; else 0
  double computed = 0;   // the points that it was decided against
  std::string why;       // for the student, too; a comment's text
  std::string who = {};  // and when, as the log has it
  std::string at = {};
};

// Throws BadInput, a line that says what would be right: for a place that the result does not have, for
// points that the place is not worth, and for a reason that is missing. Sets `computed`.
void check(Decision& decision, const SubmissionResult& computed);

// With all decisions and their reasons, for students and staff. Places that are no more change nothing.
SubmissionResult decided(SubmissionResult computed, const std::vector<Decision>& decisions);

// "points H2.3: 2 (computed: 1.5): a reason".
std::string decision_text(const Decision& decision);

// A line each: decisions that were made against other points than those that are computed now.
std::vector<std::string> conflicts(const SubmissionResult& computed, const std::vector<Decision>& decisions);

}  // namespace grader::record
