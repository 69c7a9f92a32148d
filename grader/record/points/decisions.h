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
//
// A hold changes no points: it keeps a student out of gradebooks and feedback. Its reason is for staff alone.
enum class DecisionKind { points, excuse, comment, late_days, hold };

std::string to_string(DecisionKind kind);  // "points", "excuse", "comment", "late-days", "hold"
std::optional<DecisionKind> decision_kind_from(const std::string& word);

struct Decision {
  DecisionKind kind = DecisionKind::points;
  std::string place;
  double number = 0;     // points (a comment's: more or less), or days; else 0
  double computed = 0;   // are the points when it was decided
  std::string why;       // is for the student, too; a comment's text
  std::string who = {};  // with the time, as the log has it
  std::string at = {};
  std::string title = {};    // is its category's, by which a later suite's number for it is found; else empty
  double worth = 0;          // are the points that its place could give; 0: unknown
  std::int64_t comment = 0;  // is the comment's id; else 0
  std::string code = {};     // is the line that the comment is at, as it was then
};

// Throws BadInput, a line that says what would be right: for a place that the result does not have, for
// points that the place is not worth, and for a missing reason; for points of an exercise and of its category
// at once, with `others`: nobody could say which count. Sets `computed`, `title`,
// `worth` and `code`.
void check(Decision& decision, const SubmissionResult& computed, const std::vector<Decision>& others = {});

// Applies all decisions with their reasons, for students and staff. Missing places change nothing.
SubmissionResult decided(SubmissionResult computed, const std::vector<Decision>& decisions);

// Puts it at its place in the result, or above all if there is no such place.
void say(SubmissionResult& result, const Said& said);

// Writes "points H2.3: 2 (computed: 1.5): a reason".
std::string decision_text(const Decision& decision);

// Returns the points of a place; nothing if there is no such place.
std::optional<double> points_at(SubmissionResult result, const std::string& place);

// Lists decisions that a person must make again, a line each: their place is gone, is worth or was computed
// otherwise than then; or an exercise and its category have points, as an older record allows.
std::vector<std::string> conflicts(const SubmissionResult& computed, const std::vector<Decision>& decisions);

}  // namespace grader::record
