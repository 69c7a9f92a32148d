// STAFF ONLY. `hairgrade whatif`: shows the class's totals under another course file, before it is applied.
// It grades nothing.
#include <algorithm>
#include <iostream>

#include "grader/course/course.h"
#include "grader/course/input.h"
#include "grader/record/points/hand_ins.h"
#include "grader/report/facts/text.h"
#include "grader/tool/commands/command.h"
#include "grader/tool/commands/of_a_record.h"

namespace grader::inline tool {
namespace {

struct WhatIf : OfARecord {
  std::filesystem::path course;
};

// Each exercise keeps its share of reached points.
void weigh(const Course& course, SubmissionResult& result) {
  const auto asked_for = [&](const std::string& id) {
    const auto found = std::ranges::find(course.exercises, id, &Exercise::id);
    const bool there = found != course.exercises.end() && course.asks_for(*found);
    return there ? &*found : nullptr;
  };
  std::erase_if(result.exercises,
                [&](const ExerciseResult& one) { return !is_by_hand(one) && !asked_for(one.id); });
  for (ExerciseResult& one : result.exercises) {
    if (one.max_points <= 0 || is_by_hand(one)) continue;  // is excused, or has its points already
    const Exercise& exercise = *asked_for(one.id);
    one.points *= exercise.points / one.max_points;
    one.max_points = exercise.points;
    one.extra_credit = exercise.role == Role::optional;
  }
}

int what_if(const WhatIf& options) {
  Course course = read_course(HAIR_EXERCISES_JSON, options.course);
  const HandInRules rules = read_hand_in(course, options.course, options.hand_in).rules;
  course.of_hand_in = rules.exercises;
  const std::unique_ptr<Record> record = open_record(options.folder, options.hand_in);
  double before = 0, after = 0;
  std::size_t changed = 0;
  const std::vector<std::string> names = record->names();
  for (const std::string& name : names) {
    const SubmissionResult now = record->find_under(name, record->rules(), {}).value();
    const SubmissionResult then =
        record->find_under(name, rules, [&](SubmissionResult& result) { weigh(course, result); }).value();
    before += points(now);
    after += points(then);
    const std::string line = shown_points(points(now)) + " of " + shown_points(max_points(now)) + " -> " +
                             shown_points(points(then)) + " of " + shown_points(max_points(then));
    const bool same = points(now) == points(then) && max_points(now) == max_points(then);
    changed += !same;
    if (!same) std::cout << name << "  " << line << "\n";
    for (const Adjustment& adjustment : then.adjustments)
      if (!same) std::cout << "    " << adjustment.reason << ": " << shown_points(adjustment.points) << "\n";
  }
  if (const std::string unknown = without_time(*record, names); !rules.due.empty() && !unknown.empty())
    std::cerr << "hairgrade: nobody knows whether these are late, and here they are not: " << unknown
              << "; give their times by hairgrade grade --times\n";
  const auto people = static_cast<double>(std::max<std::size_t>(1, names.size()));
  std::cout << changed << " of " << names.size() << " totals would change, the mean from "
            << shown_points(before / people) << " to " << shown_points(after / people) << "\n";
  return 0;
}

}  // namespace

Command add_whatif(CLI::App& hairgrade) {
  const auto options = std::make_shared<WhatIf>();
  CLI::App* command = hairgrade.add_subcommand(
      "whatif", "Show the class's totals under another course file, and change nothing");
  command->add_option("COURSE", options->course, "The other course file")->required();
  add_folder(*command, *options);
  return {command, [options] { return what_if(*options); }};
}

}  // namespace grader::tool
