// STAFF ONLY. `hairgrade gradescope` and `prairielearn`: each grades one hand-in in its platform's folders.
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

namespace fs = std::filesystem;

// PrairieLearn's documents promise no name of a student: all get the same inputs of a secret.
constexpr const char* kStudent = "prairielearn";

struct PlatformOptions {
  fs::path folder;
  std::string hand_in;
  GradeSettings settings;
};

Submission submission_in(const fs::path& folder, const std::string& student,
                         const GradingSettings& settings) {
  const SandboxedReader reader(HAIR_READER, settings.isolation);
  const Intake intake = read_hand_in(folder, student, settings.course, reader.opener());
  for (const std::string& notice : intake.notices) std::cerr << "hairgrade: " << notice << "\n";
  return intake.submissions.front();
}

int say_problems(const Graded& graded) {
  for (const std::string& problem : graded.problems)
    std::cerr << "hairgrade: could not grade " << printable(problem, 2000) << "\n";
  return graded.problems.empty() ? 0 : 1;
}

// Both write results.json in any case, and then throw the error, if there is one.
int grade_on_gradescope(PlatformOptions options) {
  Course course = read_course(HAIR_EXERCISES_JSON, options.settings.course);
  // Gradescope itself takes off points for lateness.
  const HandInRules rules = read_hand_in(course, options.settings.course, options.hand_in).rules;
  course.of_hand_in = options.settings.of_hand_in = rules.exercises;
  GradescopeResults results(options.folder, course, {.pictures = true});
  try {
    const Metadata metadata = read_metadata(options.folder / "submission_metadata.json");
    results.belong_to(metadata);
    GradingSettings settings = settings_of(options.settings);
    const Submission submission = submission_in(options.folder / "submission", metadata.student, settings);
    const Graded graded = Grading(std::move(settings)).grade(submission, [&](const SubmissionResult& so_far) {
      results.write(with_counted_extra_credit(rules, so_far));
    });
    const SubmissionResult counted = with_counted_extra_credit(rules, graded.result);
    results.write(counted);
    const int code = say_problems(graded);
    print_table(std::cout, {counted});
    return code;
  } catch (const std::exception&) {
    results.could_not_grade();
    throw;
  }
}

int grade_on_prairielearn(const PlatformOptions& options) {
  const auto write = [&](const SubmissionResult& result) {
    fs::create_directories(options.folder / "results");
    write_file(options.folder / "results/results.json",
               prairielearn_json(result, *options.settings.exercise));
  };
  try {
    GradingSettings settings = settings_of(options.settings);
    const Submission submission = submission_in(options.folder / "student", kStudent, settings);
    const Graded graded = Grading(std::move(settings)).grade(submission);
    write(graded.result);
    return say_problems(graded);
  } catch (const std::exception&) {
    write({.note = kCouldNotGrade});
    throw;
  }
}

void add_settings(CLI::App& command, GradeSettings& settings) {
  command.add_option("--secret", settings.secret, "A file with the staff's secret")->required();
  command.add_option("--course", settings.course, "The course file");
  command.add_option("--cache", settings.cache, "A folder for compiled objects");
}

}  // namespace

Command add_gradescope(CLI::App& hairgrade) {
  const auto options = std::make_shared<PlatformOptions>();
  CLI::App* command = hairgrade.add_subcommand(
      "gradescope", "Grade one hand-in inside Gradescope's container (run_autograder does)");
  command->add_option("FOLDER", options->folder, "The folder with submission/ and results/")->required();
  add_settings(*command, options->settings);
  command->add_option("--hand-in", options->hand_in, "The course file's hand-in");
  return {command, [options] { return grade_on_gradescope(*options); }};
}

Command add_prairielearn(CLI::App& hairgrade) {
  const auto options = std::make_shared<PlatformOptions>();
  options->folder = "/grade";
  CLI::App* command =
      hairgrade.add_subcommand("prairielearn", "Grade an exercise inside PrairieLearn's container");
  command->add_option("FOLDER", options->folder, "The folder with student/ (default: /grade)");
  command->add_option("--exercise", options->settings.exercise, "The question's exercise")->required();
  add_settings(*command, options->settings);
  return {command, [options] { return grade_on_prairielearn(*options); }};
}

}  // namespace grader::tool
