// STAFF ONLY. The points of a grading, small enough to keep for each one: the log has them. They suffice to
// say what a later grading changed, and what has changed since a student was told.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "grader/record/record.h"

namespace grader::inline record {

struct PointsThen {
  std::string place, title;  // "H2.3", "Ill-conditioned systems"; "H2" for an exercise without categories
  double points = 0, max_points = 0;
};

// Counts the categories of each exercise from 1.
std::vector<PointsThen> points_then(const SubmissionResult& result);
// Reads them from the detail of the log's entry of a grading.
std::vector<PointsThen> points_then(const LogEntry& graded);

struct PointsChange {
  std::string place, title;             // "H2.3", as it is called now
  std::optional<double> before, after;  // nothing: the place did not exist
};

// Compares categories by title, for in another suite a number may be another's.
std::vector<PointsChange> changes(const std::vector<PointsThen>& before,
                                  const std::vector<PointsThen>& after);

// Compares the last grading and the one before it. Returns nothing if there are no two gradings.
std::vector<PointsChange> changes(const std::vector<LogEntry>& log);

// Holds the points that a student was told last, by feedback or a gradebook.
struct Published {
  std::string by = {};  // is the command: "feedback moodle"
  double total = 0, max_points = 0;
  std::vector<PointsThen> points = {};  // by category, and by exercise
  std::string at = {};                  // the log has it
};

// Describes a result with decisions, under the rules of its hand-in.
Published published(const SubmissionResult& result);

// Returns a sentence for the student: "Your total was 18 of 20 points and is 20 of 20 now: H2.3 Forces 2 ->
// 4."; empty if the total is the same.
std::string change_in_words(const Published& before, const Published& now);

// Lists what makes it another total: "H2.3 Forces 2 -> 4; S1 3 -> 4"; if more categories have changed,
// exercises.
std::string changed_places(const Published& before, const Published& now,
                           std::size_t most_categories = std::numeric_limits<std::size_t>::max());

}  // namespace grader::record

namespace grader {

template <>
struct Fields<PointsThen> {
  static const Rows<PointsThen>& rows();
};
template <>
struct Fields<Published> {
  static const Rows<Published>& rows();
};

}  // namespace grader
