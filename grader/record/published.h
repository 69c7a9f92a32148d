// STAFF ONLY. The points that a student was told last, by feedback or a gradebook.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "grader/record/points/points_then.h"

namespace grader::inline record {

struct Published {
  std::string by = {};  // is the command: "feedback moodle"
  double total = 0, max_points = 0;
  std::vector<PointsThen> points = {};  // by category, and by exercise
  std::string at = {};                  // the log has it
};

// Describes a result with decisions, under the rules of its hand-in.
Published published(const SubmissionResult& result);

// Returns a sentence for the student: "Your total was 18 of 20 points and is 20 of 20 now: H2.3 Forces 2 -> 4.";
// empty if the total is the same.
std::string change_in_words(const Published& before, const Published& now);

// Lists what makes it another total: "H2.3 Forces 2 -> 4; S1 3 -> 4"; if more categories have changed, exercises.
std::string changed_places(const Published& before, const Published& now,
                           std::size_t most_categories = std::numeric_limits<std::size_t>::max());

}  // namespace grader::record

namespace grader {

template <>
struct Fields<Published> {
  static const Rows<Published>& rows();
};

}  // namespace grader
