// STAFF ONLY. Lists the points of a grading by category.
#include "grader/record/points/points_then.h"

#include "grader/result/json_fields.h"

namespace grader {

const Rows<PointsThen>& Fields<PointsThen>::rows() {
  using T = PointsThen;
  static const Rows<T> all = {field("place", &T::place), field("title", &T::title),
                              field("points", &T::points), field("max_points", &T::max_points)};
  return all;
}

}  // namespace grader

namespace grader::inline record {

std::vector<PointsThen> points_then(const SubmissionResult& result) {
  std::vector<PointsThen> all;
  for (const ExerciseResult& exercise : result.exercises) {
    if (exercise.cases.empty())
      all.push_back({exercise.id, exercise.title, exercise.points, exercise.max_points});
    for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
      const CaseResult& one = exercise.cases[i];
      all.push_back({exercise.id + "." + std::to_string(i + 1), one.name, one.points, one.max_points});
    }
  }
  return all;
}

std::vector<PointsThen> points_then(const std::string& detail, const std::string& name) {
  return from_json_text<std::vector<PointsThen>>(detail, name);
}

}  // namespace grader::record
