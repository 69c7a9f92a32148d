// STAFF ONLY. `hairgrade log`: lists changes of a student's grades, with their author and time.
#include <iostream>

#include "grader/course/input.h"
#include "grader/record/changes.h"
#include "grader/report/facts/text.h"
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

}  // namespace

Command add_log(CLI::App& hairgrade) {
  const auto options = std::make_shared<OfARecord>();
  CLI::App* command =
      hairgrade.add_subcommand("log", "Tell who did what with a student's grades, and when (UTC)");
  add_name(*command, *options);
  add_folder(*command, *options);
  return {command, [options] { return log(*options); }};
}

}  // namespace grader::tool
