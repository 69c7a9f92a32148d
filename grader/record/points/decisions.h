// STAFF ONLY. Decisions of people about a student's results. They are stored beside the computed results and
// never replace them, so they survive each regrade, and can be undone.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "grader/result/result.h"

namespace grader::inline record {

// A place in a result is an exercise, "H2", or a category of it, "H2.3"; "" is the whole. Comments and
// requests may be at a line of the exercise's file, "H2:17".
//
// A comment is an object that several people may have (comments.h), at a place each: its text and points
// are the same for all, and a place may have several. Points of comments are given at their places, or taken,
// after points that were set; never below 0 or above what a place is worth.
enum class DecisionKind { points, excuse, comment, late_days };

std::string to_string(DecisionKind kind);  // "points", "excuse", "comment", "late-days"
std::optional<DecisionKind> decision_kind_from(const std::string& word);

struct Decision {
  DecisionKind kind = DecisionKind::points;
  std::string place;
  double number = 0;     // points (a comment's: more or less), or days; else 0
  double computed = 0;   // are the points when it was decided
  std::string why;       // is for the student, too; a comment's text
  std::string who = {};  // with the time, as the log has it
  std::string at = {};
  std::int64_t comment = 0;  // is the comment's id; else 0
  std::string code = {};     // is the line that the comment is at, as it was then
};

// Throws BadInput for a place that is not in the result. Returns the line of "H2:17", "" for other places.
std::string check_place(const std::string& place, const SubmissionResult& computed);

// Returns the title of a category; "" for other places.
std::string category_at(const std::string& place, SubmissionResult result);

// Throws BadInput, a line that says what would be right: for a place that the result does not have, for
// points that the place is not worth, and for a missing reason. Sets `computed` and `code`.
void check(Decision& decision, const SubmissionResult& computed);

// Applies all decisions with their reasons, for students and staff. Missing places change nothing.
SubmissionResult decided(SubmissionResult computed, const std::vector<Decision>& decisions);

// Puts it at its place in the result, or above all if there is no such place.
void say(SubmissionResult& result, const Said& said);

// Writes "points H2.3: 2 (computed: 1.5): a reason".
std::string decision_text(const Decision& decision);

// Lists decisions that were made when other points than the present ones were computed, a line each.
std::vector<std::string> conflicts(const SubmissionResult& computed, const std::vector<Decision>& decisions);

}  // namespace grader::record
