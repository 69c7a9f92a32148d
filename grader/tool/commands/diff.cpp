// STAFF ONLY. `hairgrade diff`: lists changes of the last grading, by student and category.
#include <iostream>

#include "grader/course/input.h"
#include "grader/record/changes.h"
#include "grader/report/facts/text.h"
#include "grader/tool/commands/command.h"
#include "grader/tool/commands/of_a_record.h"

namespace grader::inline tool {
namespace {

std::string shown(const std::optional<double>& points) {
  return points ? shown_points(*points) : "not there";
}

int diff(const OfARecord& options, const std::string& since) {
  const std::unique_ptr<Record> record = open_record(options.folder, options.hand_in);
  const NamesForPeople people = record->names_for_people();
  int students = 0;
  for (const std::string& name : record->names()) {
    const std::vector<PointsChange> all = changes(record->log(name), since);
    students += !all.empty();
    const std::string who = called(name, people);
    for (const PointsChange& one : all)
      std::cout << who << "  " << one.place << "  " << shown(one.before) << " -> " << shown(one.after) << "  "
                << printable(one.title) << "\n";
  }
  std::cout << (students == 0 ? "nobody's"
                              : std::to_string(students) + (students == 1 ? " student's" : " students'"))
            << " points have changed\n";
  return 0;
}

}  // namespace

Command add_diff(CLI::App& hairgrade) {
  const auto options = std::make_shared<OfARecord>();
  const auto since = std::make_shared<std::string>();
  CLI::App* command = hairgrade.add_subcommand(
      "diff", "Tell what each student's last grading changed, by category, against the one before");
  add_folder(*command, *options);
  command
      ->add_option("--since", *since,
                   "Compare with the last grading up to this time (UTC), such as \"2025-03-04 10:15:00\"")
      ->check([](const std::string& text) {
        const std::string form = "dddd-dd-dd dd:dd:dd";
        bool right = text.size() == form.size();
        for (std::size_t i = 0; right && i < form.size(); ++i)
          right = form[i] == 'd' ? text[i] >= '0' && text[i] <= '9' : text[i] == form[i];
        return right ? "" : "write a time such as \"2025-03-04 10:15:00\"";
      });
  return {command, [options, since] { return diff(*options, *since); }};
}

}  // namespace grader::tool
