// STAFF ONLY. `hairgrade gradescope`: grades one hand-in in Gradescope's folders.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "grader/course/input.h"
#include "grader/grading/grading.h"
#include "grader/intake/archives/sandboxed_archive.h"
#include "grader/intake/read_submissions.h"
#include "grader/record/points/hand_ins.h"
#include "grader/report/report.h"
#include "grader/tool/commands/command.h"
#include "grader/tool/commands/grade_settings.h"
#include "grader/tool/gradescope_hand_in.h"

namespace grader::inline tool {
namespace {

struct GradescopeOptions {
  std::filesystem::path folder;
  std::string hand_in;
  GradeSettings settings;
};

// Writes results.json in any case, and then throws the error, if there is one.
int grade_on_gradescope(GradescopeOptions options) {
  Course course = read_course(HAIR_EXERCISES_JSON, options.settings.course);
  // Gradescope itself takes off points for lateness.
  const HandInRules rules = read_hand_in(course, options.settings.course, options.hand_in).rules;
  course.of_hand_in = rules.exercises;
  options.settings.of_hand_in = course.of_hand_in;
  GradescopeResults results(options.folder, course, {.pictures = true});
  try {
    const Metadata metadata = read_metadata(options.folder / "submission_metadata.json");
    results.belong_to(metadata);
    GradingSettings settings = settings_of(options.settings);
    const SandboxedReader reader(HAIR_READER, settings.isolation);
    const Intake intake =
        read_hand_in(options.folder / "submission", metadata.student, course, reader.opener());
    for (const std::string& notice : intake.notices) std::cerr << "hairgrade: " << notice << "\n";
    const Grading grading(std::move(settings));
    const Graded graded = grading.grade(intake.submissions.front(), [&](const SubmissionResult& so_far) {
      results.write(with_counted_extra_credit(rules, so_far));
    });
    const SubmissionResult counted = with_counted_extra_credit(rules, graded.result);
    results.write(counted);
    for (const std::string& problem : graded.problems)
      std::cerr << "hairgrade: could not grade " << printable(problem, 2000) << "\n";
    print_table(std::cout, {counted});
    return graded.problems.empty() ? 0 : 1;
  } catch (const std::exception&) {
    results.could_not_grade();
    throw;
  }
}

}  // namespace

Command add_gradescope(CLI::App& hairgrade) {
  const auto options = std::make_shared<GradescopeOptions>();
  CLI::App* command = hairgrade.add_subcommand(
      "gradescope", "Grade one hand-in inside Gradescope's container (run_autograder does)");
  command->add_option("FOLDER", options->folder, "The folder with submission/ and results/")->required();
  command->add_option("--secret", options->settings.secret, "A file with the staff's secret")->required();
  command->add_option("--course", options->settings.course, "The course file");
  command->add_option("--hand-in", options->hand_in, "The course file's hand-in");
  command->add_option("--cache", options->settings.cache, "A folder for compiled objects");
  return {command, [options] { return grade_on_gradescope(*options); }};
}

}  // namespace grader::tool
