// STAFF ONLY. `hairgrade gradebook`: writes grades for a learning system's import.
#include <CLI/CLI.hpp>
#include <iostream>
#include <map>
#include <memory>

#include "grader/course/input.h"
#include "grader/gradebook/filling.h"
#include "grader/gradebook/recorded_grades.h"
#include "grader/report/facts/student_text.h"
#include "grader/tool/commands/command.h"
#include "grader/tool/commands/course_folder.h"
#include "grader/tool/commands/of_a_record.h"

namespace grader::inline tool {
namespace {

namespace fs = std::filesystem;

struct GradebookOptions {
  std::string system, column, hand_in;
  fs::path grades, out;
  std::optional<fs::path> fill, roster;
  bool scale = false, overwrite = false;
  std::vector<std::string> problems;
};

using Fill = Gradebook (*)(const Csv&, const std::vector<Grade>&, const FillOptions&);
const std::map<std::string, Fill>& fills() {
  static const std::map<std::string, Fill> all{{"blackboard", fill_blackboard},
                                               {"brightspace", fill_brightspace},
                                               {"canvas", fill_canvas},
                                               {"moodle", fill_moodle}};
  return all;
}

Gradebook gradebook_of(const GradebookOptions& options, Record& record, const std::vector<Grade>& grades) {
  std::optional<Roster> roster;
  if (options.roster) roster = Roster(read_csv(*options.roster));
  const FillOptions filling{options.column.empty() ? record.rules().column : options.column, options.scale,
                            roster ? &*roster : nullptr, options.overwrite, [&](const std::string& hand_in) {
                              return first_lines(record.find_decided(hand_in)->result);
                            }};
  const std::string& system = options.system;
  if (system == "autolab") {
    if (options.fill)
      throw BadInput(
          "gradebook autolab: takes no --fill, for its rows are whole; give --roster for e-mail addresses");
    std::vector<std::string> problems = options.problems;
    if (problems.empty())
      for (const auto& [id, points] : grades.front().exercises) problems.push_back(id);
    return autolab_rows(grades, problems, filling.roster);
  }
  std::optional<Csv> exported;
  if (options.fill) exported = read_csv(*options.fill);
  if (system == "gradescope") return plain_rows(system, exported ? &*exported : nullptr, grades, filling);
  if (!exported)
    throw BadInput("gradebook " + system + ": needs --fill with the table that " + system +
                   " exports: grades are filled into it");
  return fills().at(system)(*exported, grades, filling);
}

int write_gradebook(const GradebookOptions& options) {
  std::error_code none;
  if (options.fill && fs::equivalent(*options.fill, options.out, none))
    throw BadInput("--out " + printable(options.out.string(), 4096) +
                   ": is the exported table itself; name a new file");
  const std::unique_ptr<Record> record = open_record(options.grades, options.hand_in);
  const RecordedGrades recorded = recorded_grades(*record, options.grades);
  const Gradebook book = gradebook_of(options, *record, recorded.grades);
  write_file(options.out, book.csv);
  record->put_entered(book.entered);
  put_published(*record, recorded, book.given, "gradebook " + options.system);
  for (const std::string& line : recorded.held) std::cerr << "hairgrade: " << line << "\n";
  for (const std::string& line : book.said) std::cerr << "hairgrade: " << line << "\n";
  std::cout << book.written << " grades in " << options.out.string() << "\n";
  return book.all_entered && recorded.held.empty() ? 0 : 3;
}

}  // namespace

Command add_gradebook(CLI::App& hairgrade) {
  const auto options = std::make_shared<GradebookOptions>();
  CLI::App* command =
      hairgrade.add_subcommand("gradebook", "Fill grades into a table that a learning system imports");
  command
      ->add_option("SYSTEM", options->system,
                   "canvas, moodle, brightspace, autolab, gradescope or blackboard")
      ->required()
      ->check(CLI::IsMember({"canvas", "moodle", "brightspace", "autolab", "gradescope", "blackboard"}));
  needed_elsewhere(command->add_option("--grades", options->grades, "The folder of hairgrade grade --out"),
                   options->grades, kGrades);
  command->add_option("--fill", options->fill,
                      "The table that the system exports: gradebook, worksheet, or class list");
  command->add_option("--out", options->out, "The new table")->required();
  command->add_option("--column", options->column,
                      "The assignment's column, by title, in Canvas and Blackboard also by number (default: "
                      "the course file's)");
  add_hand_in(*command, options->hand_in);
  command->add_flag("--scale", options->scale, "Give shares of the column's points, if it is out of others");
  command->add_flag("--overwrite", options->overwrite,
                    "Replace cells that a person filled in, too: those that no earlier call of this entered");
  command->add_option("--roster", options->roster,
                      "A table of people, for hand-ins that came by another system");
  command
      ->add_option("--problems", options->problems,
                   "autolab: exercises, or total, in the order of the lab's problems")
      ->delimiter(',');
  return {command, [options] { return write_gradebook(*options); }};
}

}  // namespace grader::tool
