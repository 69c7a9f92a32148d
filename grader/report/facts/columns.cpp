// STAFF ONLY. Chooses the columns of tables.
#include "grader/report/facts/columns.h"

#include <algorithm>

#include "grader/report/facts/text.h"

namespace grader::inline report {
namespace {

std::string word(Status status) {
  switch (status) {
    case Status::passed:
    case Status::partly:
      return "0";  // the exercise is worth nothing
    case Status::wrong:
      return "wrong";
    case Status::not_implemented:
      return "stub";
    case Status::missing:
      return "-";
    case Status::does_not_compile:
      return "build";
    case Status::crashed:
      return "crash";
    case Status::timed_out:
      return "time";
    case Status::out_of_memory:
      return "mem";
    case Status::broke_rules:
      return "rules";
    case Status::not_taken:
      return "look";
    case Status::unreadable:
      return "file";
    case Status::excused:
      return "exc";
    case Status::given:
      return "0";
    case Status::not_given:
      return "";
  }
  return "";
}

}  // namespace

std::vector<Column> columns_of(const std::vector<SubmissionResult>& results) {
  std::vector<Column> columns;
  for (const SubmissionResult& result : results) {
    for (const ExerciseResult& exercise : result.exercises) {
      const auto known = std::ranges::find(columns, exercise.id, &Column::id);
      if (known == columns.end())
        columns.push_back({exercise.id, exercise.title, exercise.max_points, exercise.extra_credit});
      else  // it is worth nothing for people who are excused
        known->max_points = std::max(known->max_points, exercise.max_points);
    }
  }
  return columns;
}

const ExerciseResult* find_exercise(const SubmissionResult& result, const std::string& id) {
  const auto found = std::find_if(result.exercises.begin(), result.exercises.end(),
                                  [&](const ExerciseResult& exercise) { return exercise.id == id; });
  return found == result.exercises.end() ? nullptr : &*found;
}

std::string in_short(const ExerciseResult& exercise) {
  if (exercise.status == Status::excused) return word(exercise.status);
  if (exercise.points_set && exercise.status != Status::given) return short_points(exercise.points) + "*";
  if (exercise.points <= 0) return word(exercise.status);
  const bool to_its_end =
      exercise.status == Status::passed || exercise.status == Status::partly || is_by_hand(exercise);
  return short_points(exercise.points) + (to_its_end ? "" : "!");
}

bool is_excused_from_all(const SubmissionResult& result) {
  return !result.exercises.empty() &&
         std::ranges::all_of(
             result.exercises, [](Status status) { return status == Status::excused; },
             &ExerciseResult::status);
}

std::string in_short(const Decided& decided) {
  return (decided.conflict.empty() ? "" : "conflict: ") + decided.kind +
         (decided.place.empty() ? "" : " " + decided.place);
}

std::string decided_in_short(const SubmissionResult& result) {
  std::vector<std::string> all;
  for (const Decided& decided : result.decided) all.push_back(in_short(decided));
  return in_a_row(all);
}

std::string not_given_yet(const SubmissionResult& result) {
  std::vector<std::string> titles;
  for (const ExerciseResult& exercise : result.exercises)
    if (!is_given(exercise)) titles.push_back(exercise.title);
  return titles.empty() ? "" : in_a_row(titles) + (titles.size() > 1 ? " are" : " is") + " not given yet";
}

std::string in_a_row(const std::vector<std::string>& words) {
  std::string row;
  for (const std::string& word : words) row += (row.empty() ? "" : ", ") + word;
  return row;
}

Isolation least_isolation(const std::vector<SubmissionResult>& results) {
  Isolation least = Isolation::namespaces;
  for (const SubmissionResult& result : results)
    if (least != Isolation::none && result.isolation != Isolation::namespaces) least = result.isolation;
  return least;
}

bool all_with_images(const std::vector<SubmissionResult>& results) {
  return std::all_of(results.begin(), results.end(),
                     [](const SubmissionResult& result) { return result.images; });
}

}  // namespace grader::report
