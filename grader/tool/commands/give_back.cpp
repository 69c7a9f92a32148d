// STAFF ONLY. `hairgrade gradebook` and `feedback` write grades and reports in the forms of learning systems.
#include <CLI/CLI.hpp>
#include <iostream>
#include <map>
#include <memory>

#include "grader/course/course.h"
#include "grader/course/input.h"
#include "grader/gradebook/feedback.h"
#include "grader/gradebook/filling.h"
#include "grader/gradebook/recorded_grades.h"
#include "grader/grading/isolation_here.h"
#include "grader/intake/archives/sandboxed_archive.h"
#include "grader/intake/submission.h"
#include "grader/record/record.h"
#include "grader/report/facts/student_text.h"
#include "grader/tool/commands/command.h"
#include "grader/tool/commands/of_a_record.h"
#include "hair/io/files/read_file.h"

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

struct FeedbackOptions {
  std::string system, hand_in;
  fs::path table, grades, out;
};

std::vector<std::string> files_in(const fs::path& download) {
  std::vector<std::string> files;
  if (fs::is_directory(download)) {
    for (const auto& entry : fs::recursive_directory_iterator(download))
      if (entry.is_regular_file()) files.push_back(entry.path().filename().string());
    return files;
  }
  if (!fs::exists(download))
    throw BadInput(printable(download.string(), 4096) + ": is not there; give the download that was graded");
  const IntakeLimits limits;
  const StagedKit kit(HAIR_KIT_DIR, read_course(HAIR_EXERCISES_JSON));
  const SandboxedReader reader(HAIR_READER, isolation_here(kit, {}));
  try {
    const auto archive =
        reader.opener()(download, download.filename().string(),
                        {.unpacked_bytes = limits.unpacked_bytes, .entries = 50 * limits.entries});
    for (const Entry& entry : archive->list()) files.push_back(entry.path);
  } catch (const std::exception& problem) {
    throw BadInput(printable(download.string(), 4096) + ": can't be read (" + problem.what() +
                   "); give the download that was graded");
  }
  return files;
}

int write_feedback(const FeedbackOptions& options) {
  if (options.out.extension() != ".zip")
    throw BadInput("--out " + printable(options.out.string(), 4096) +
                   ": the archive is a .zip; give it such a name");
  const std::unique_ptr<Record> record = open_record(options.grades, options.hand_in);
  const RecordedGrades recorded = recorded_grades(*record, options.grades);
  std::set<std::string> given;
  const ReportOf report = [&](const std::string& hand_in) {
    given.insert(hand_in);
    const fs::path page = record->pages() / hand_in / "report.html";
    std::string bytes = hair::bytes_of(page);
    if (bytes.empty())
      throw BadInput(printable(page.string(), 4096) + ": is not there; grade again, which writes it");
    return ReportOfStudent{std::move(bytes), student_text(record->find_decided(hand_in)->result)};
  };
  const Feedback feedback = options.system == "canvas"
                                ? feedback_for_canvas(files_in(options.table), recorded.grades, report)
                                : feedback_for_moodle(read_csv(options.table), recorded.grades, report);
  for (const std::string& line : recorded.held) std::cerr << "hairgrade: " << line << "\n";
  for (const std::string& line : feedback.said) std::cerr << "hairgrade: " << line << "\n";
  if (feedback.entries.empty())
    throw BadInput(printable(options.table.string(), 4096) +
                   ": nobody in it gets feedback; give the one that these hand-ins came with");
  write_zip(options.out, feedback.entries);
  put_published(*record, recorded, given, "feedback " + options.system);
  std::cout << feedback.entries.size() << " reports in " << options.out.string() << "\n";
  return 0;
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

Command add_feedback(CLI::App& hairgrade) {
  const auto options = std::make_shared<FeedbackOptions>();
  CLI::App* command = hairgrade.add_subcommand(
      "feedback", "Pack the reports into an archive that a learning system hands out");
  command->add_option("SYSTEM", options->system, "canvas or moodle")
      ->required()
      ->check(CLI::IsMember({"canvas", "moodle"}));
  command
      ->add_option("TABLE", options->table,
                   "canvas: the download that was graded. moodle: the grading worksheet")
      ->required();
  needed_elsewhere(command->add_option("--grades", options->grades, "The folder of hairgrade grade --out"),
                   options->grades, kGrades);
  add_hand_in(*command, options->hand_in);
  command->add_option("--out", options->out, "The archive, a .zip")->required();
  return {command, [options] { return write_feedback(*options); }};
}

}  // namespace grader::tool
