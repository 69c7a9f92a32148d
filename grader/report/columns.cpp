// STAFF ONLY.
#include "grader/report/columns.h"

#include <algorithm>

namespace grader {

std::vector<Column> columns_of(const std::vector<SubmissionResult>& results) {
  std::vector<Column> columns;
  for (const SubmissionResult& result : results) {
    for (const ExerciseResult& exercise : result.exercises) {
      const bool known = std::any_of(columns.begin(), columns.end(),
                                     [&](const Column& column) { return column.id == exercise.id; });
      if (!known)
        columns.push_back({exercise.id, exercise.title, exercise.max_points, exercise.extra_credit});
    }
  }
  return columns;
}

const ExerciseResult* find_exercise(const SubmissionResult& result, const std::string& id) {
  const auto found = std::find_if(result.exercises.begin(), result.exercises.end(),
                                  [&](const ExerciseResult& exercise) { return exercise.id == id; });
  return found == result.exercises.end() ? nullptr : &*found;
}

bool all_isolated(const std::vector<SubmissionResult>& results) {
  return std::all_of(results.begin(), results.end(),
                     [](const SubmissionResult& result) { return result.isolated; });
}

}  // namespace grader
