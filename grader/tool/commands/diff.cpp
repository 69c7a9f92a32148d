// STAFF ONLY. `hairgrade diff`: lists changes of the last grading, by student and category.
#include <iostream>

#include "grader/class_folder/class_files.h"
#include "grader/course/input.h"
#include "grader/gradebook/recorded_grades.h"
#include "grader/report/report.h"
#include "grader/tool/commands/command.h"
#include "grader/tool/commands/of_a_record.h"

namespace grader::inline tool {
namespace {

struct Diff : OfARecord {
  std::optional<std::filesystem::path> published;
};

int diff(const Diff& options) {
  const std::unique_ptr<Record> record = open_record(options.folder, options.hand_in);
  if (options.published) {
    const PublishedChanges found = published_changes(*record);
    write_file(*options.published, found.csv);
    std::cout << found.students << " published totals have changed: " << options.published->string() << "\n";
    return 0;
  }
  const NamesForPeople people = record->names_for_people();
  const ClassChanges all = class_changes(*record);
  for (const auto& [name, theirs] : all)
    for (const PointsChange& one : theirs)
      std::cout << called(name, people) << "  " << one.place << "  " << shown_change(one) << "  "
                << printable(one.title) << "\n";
  std::cout << (all.empty() ? "nobody's"
                            : std::to_string(all.size()) + (all.size() == 1 ? " student's" : " students'"))
            << " points have changed\n";
  return 0;
}

}  // namespace

Command add_diff(CLI::App& hairgrade) {
  const auto options = std::make_shared<Diff>();
  CLI::App* command = hairgrade.add_subcommand(
      "diff", "Tell what each student's last grading changed, by category, against the one before");
  add_folder(*command, *options);
  command->add_option("--published", options->published,
                      "Write a table of those whose total is another than feedback or gradebook had, with "
                      "e-mail addresses; name a .csv");
  return {command, [options] { return diff(*options); }};
}

}  // namespace grader::tool
