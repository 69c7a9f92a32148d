// STAFF ONLY. Reads grades from a record.
#include "grader/gradebook/recorded_grades.h"

#include <algorithm>

#include "grader/course/input.h"
#include "grader/record/changes.h"
#include "grader/record/record.h"
#include "grader/report/facts/columns.h"
#include "grader/report/facts/text.h"
#include "grader/text/csv.h"

namespace grader::inline gradebook {

RecordedGrades recorded_grades(Record& record, const std::filesystem::path& folder) {
  const std::string where = printable(folder.string(), 4096);
  RecordedGrades all;
  for (const HandIn& hand_in : record.hand_ins()) {
    const std::optional<Recorded> found = record.find_decided(hand_in.name);
    if (!found) continue;
    const SubmissionResult& result = found->result;
    const std::vector<Decision> decisions = record.decisions(hand_in.name);
    if (const auto hold = std::ranges::find(decisions, DecisionKind::hold, &Decision::kind);
        hold != decisions.end()) {
      all.held.push_back(hand_in.name + ": gets nothing, since " + hold->who + " holds it: " +
                         printable(hold->why, 2000) + "; hairgrade unhold " + hand_in.name + " ends that");
      continue;
    }
    Grade grade{.hand_in = hand_in.name,
                .owner = hand_in.owner,
                .system = hand_in.system,
                .points = points(result),
                .max_points = max_points(result),
                .excused = std::ranges::any_of(decisions,
                                               [](const Decision& one) {
                                                 return one.kind == DecisionKind::excuse && one.place.empty();
                                               }),
                .not_final = result.ended_by_the_clock.empty() ? not_given_yet(result)
                                                               : "the clock ended a part of it",
                .entered = record.entered(hand_in.name)};
    for (const ExerciseResult& exercise : result.exercises)
      if (is_given(exercise)) grade.exercises.emplace_back(exercise.id, exercise.points);
    all.grades.push_back(std::move(grade));
    all.points[hand_in.name] = published(result);
  }
  if (all.grades.empty())
    throw BadInput(where + (all.held.empty()
                                ? ": its record has no grades yet; grade first"
                                : ": all who have grades are held; end that by hairgrade unhold"));
  return all;
}

void put_published(Record& record, RecordedGrades recorded, const std::set<std::string>& given,
                   const std::string& by) {
  std::erase_if(recorded.points, [&](const auto& one) { return !given.contains(one.first); });
  for (auto& [name, one] : recorded.points) one.by = by;
  record.put_published(recorded.points);
}

PublishedChanges published_changes(Record& record) {
  PublishedChanges all{csv_line(
      {"submission", "name", "id", "e-mail", "old", "new", "category", "sentence", "published", "by"})};
  const std::vector<ClassLine> people = lines_of(record.class_list(), record.hand_ins());
  for (const std::string& name : record.names()) {
    const std::optional<Published> then = record.published(name);
    if (!then) continue;
    const Published now = published(record.find_decided(name)->result);
    const std::string sentence = change_in_words(*then, now);
    if (sentence.empty()) continue;
    ++all.students;
    const auto add = [&](const ClassLine& line) {
      all.csv +=
          csv_line({name, line.name, line.id, line.email, shown_points(then->total), shown_points(now.total),
                    changed_places(*then, now), sentence, then->at, then->by});
    };
    const std::size_t before = all.csv.size();
    for (const ClassLine& line : people)
      if (line.hand_in == name) add(line);
    if (all.csv.size() == before) add({});
  }
  return all;
}

}  // namespace grader::gradebook
