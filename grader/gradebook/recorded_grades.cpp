// STAFF ONLY. Reads grades from a record.
#include "grader/gradebook/recorded_grades.h"

#include <algorithm>

#include "grader/course/input.h"
#include "grader/record/record.h"
#include "grader/report/facts/columns.h"

namespace grader::inline gradebook {

std::vector<Grade> recorded_grades(Record& record, const std::filesystem::path& folder) {
  const std::string where = printable(folder.string(), 4096);
  std::vector<Grade> grades;
  for (const HandIn& hand_in : record.hand_ins()) {
    const std::optional<Recorded> found = record.find_decided(hand_in.name);
    if (!found) continue;
    const SubmissionResult& result = found->result;
    Grade grade{.hand_in = hand_in.name,
                .owner = hand_in.owner,
                .system = hand_in.system,
                .points = points(result),
                .max_points = max_points(result),
                .excused = std::ranges::any_of(record.decisions(hand_in.name),
                                               [](const Decision& one) {
                                                 return one.kind == DecisionKind::excuse && one.place.empty();
                                               }),
                .not_final = result.ended_by_the_clock.empty() ? not_given_yet(result)
                                                               : "the clock ended a part of it",
                .entered = record.entered(hand_in.name)};
    for (const ExerciseResult& exercise : result.exercises)
      if (is_given(exercise)) grade.exercises.emplace_back(exercise.id, exercise.points);
    grades.push_back(std::move(grade));
  }
  if (grades.empty()) throw BadInput(where + ": its record has no grades yet; grade first");
  return grades;
}

}  // namespace grader::gradebook
