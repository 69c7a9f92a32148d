// STAFF ONLY. `hairgrade prairielearn`: grades one exercise in PrairieLearn's folders.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "grader/course/input.h"
#include "grader/grading/grading.h"
#include "grader/intake/archives/sandboxed_archive.h"
#include "grader/intake/read_submissions.h"
#include "grader/report/report.h"
#include "grader/report/results_json.h"
#include "grader/tool/commands/command.h"
#include "grader/tool/commands/grade_settings.h"
#include "grader/tool/gradescope_hand_in.h"

namespace grader::inline tool {
namespace {

// The platform's documents promise no name of a student: all get the same inputs of a secret.
constexpr const char* kStudent = "prairielearn";

struct PrairieLearnOptions {
  std::filesystem::path folder = "/grade";
  GradeSettings settings;
};

// Writes results.json in any case, and then throws the error, if there is one.
int grade_on_prairielearn(const PrairieLearnOptions& options) {
  const std::string& exercise = *options.settings.exercise;
  const auto write = [&](const SubmissionResult& result) {
    std::filesystem::create_directories(options.folder / "results");
    write_file(options.folder / "results/results.json", prairielearn_json(result, exercise));
  };
  try {
    GradingSettings settings = settings_of(options.settings);
    const SandboxedReader reader(HAIR_READER, settings.isolation);
    const Intake intake =
        read_hand_in(options.folder / "student", kStudent, settings.course, reader.opener());
    for (const std::string& notice : intake.notices) std::cerr << "hairgrade: " << notice << "\n";
    const Graded graded = Grading(std::move(settings)).grade(intake.submissions.front());
    write(graded.result);
    for (const std::string& problem : graded.problems)
      std::cerr << "hairgrade: could not grade " << printable(problem, 2000) << "\n";
    return graded.problems.empty() ? 0 : 1;
  } catch (const std::exception&) {
    SubmissionResult nothing;
    nothing.note = kCouldNotGrade;
    write(nothing);
    throw;
  }
}

}  // namespace

Command add_prairielearn(CLI::App& hairgrade) {
  const auto options = std::make_shared<PrairieLearnOptions>();
  CLI::App* command =
      hairgrade.add_subcommand("prairielearn", "Grade an exercise inside PrairieLearn's container");
  command->add_option("FOLDER", options->folder, "The folder with student/ (default: /grade)");
  command->add_option("--exercise", options->settings.exercise, "The question's exercise")->required();
  command->add_option("--secret", options->settings.secret, "A file with the staff's secret")->required();
  command->add_option("--course", options->settings.course, "The course file");
  command->add_option("--cache", options->settings.cache, "A folder for compiled objects");
  return {command, [options] { return grade_on_prairielearn(*options); }};
}

}  // namespace grader::tool
