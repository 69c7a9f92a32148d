// STAFF ONLY. `hairgrade log`, `diff` and `export` print a record: the changes of a student's grades, those
// of the last grading, and all of it as JSON for other programs.
#include <iostream>

#include "grader/class_folder/class_files.h"
#include "grader/course/input.h"
#include "grader/gradebook/recorded_grades.h"
#include "grader/record/changes.h"
#include "grader/report/facts/text.h"
#include "grader/report/report.h"
#include "grader/result/json_fields.h"
#include "grader/tool/commands/command.h"
#include "grader/tool/commands/of_a_record.h"

namespace grader::inline tool {
namespace {

// Leaves out points by category, which are too many for a line.
std::string in_short(const LogEntry& entry) {
  if (entry.did == "published") {
    const auto one = from_json_text<Published>(entry.detail, "the log");
    return shown_points(one.total) + " of " + shown_points(one.max_points) + " points, by " + one.by;
  }
  if (entry.did != "graded") return entry.detail;
  double sum = 0;
  for (const PointsThen& one : points_then(entry)) sum += one.points;
  return shown_points(sum) + " points computed";
}

int log(const OfARecord& options) {
  const std::unique_ptr<Record> record = open_record(options.folder, options.hand_in);
  const std::string name = hand_in_called(*record, options.name);
  const std::vector<LogEntry> entries = record->log(name);
  if (const NamesForPeople people = record->names_for_people(); people.contains(name))
    std::cout << called(name, people) << "\n";
  for (const LogEntry& entry : entries)
    std::cout << entry.at << "  " << printable(entry.who) << "  " << entry.did << "  "
              << printable(in_short(entry), 2000) << "\n";
  return 0;
}

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

Command add_log(CLI::App& hairgrade) {
  const auto options = std::make_shared<OfARecord>();
  CLI::App* command =
      hairgrade.add_subcommand("log", "Tell who did what with a student's grades, and when (UTC)");
  add_name(*command, *options);
  add_folder(*command, *options);
  return {command, [options] { return log(*options); }};
}

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

Command add_export(CLI::App& hairgrade) {
  const auto options = std::make_shared<OfARecord>();
  CLI::App* command =
      hairgrade.add_subcommand("export", "Print the record of a class as JSON, without pictures");
  add_folder(*command, *options);
  return {command, [options] {
            std::cout << open_record(options->folder, options->hand_in)->export_json();
            return 0;
          }};
}

}  // namespace grader::tool
