// STAFF ONLY. `hairgrade handout` makes the archive for students, and `hairgrade package` packs the grader
// for a platform.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "grader/course/course.h"
#include "grader/course/input.h"
#include "grader/grading/secret.h"
#include "grader/package/gradescope_package.h"
#include "grader/package/handout.h"
#include "grader/package/prairielearn_course.h"
#include "grader/record/points/hand_ins.h"
#include "grader/tool/commands/command.h"
#include "grader/tool/commands/of_a_record.h"
#include "grader/tool/gradescope_hand_in.h"

namespace grader::inline tool {
namespace {

namespace fs = std::filesystem;

struct HandoutOptions {
  fs::path out;
  std::optional<fs::path> course;
  bool accept = false;
};

int handout(const HandoutOptions& options) {
  const std::string name = options.out.filename().string();
  if (!name.ends_with(".tar.gz") && !name.ends_with(".tgz"))
    throw BadInput("--out " + options.out.string() + ": the handout is a .tar.gz; give it such a name");
  const Course course = read_course(HAIR_EXERCISES_JSON, options.course);
  const HandoutSources sources{HAIR_SOURCE_DIR, HAIR_GOLDEN_DIR};
  if (options.accept) accept_files(sources, course);
  if (const std::string remark = make_handout(sources, course, options.out); !remark.empty())
    std::cerr << remark << "\n";
  std::cout << options.out.string() << "\n";
  return 0;
}

int package_for_gradescope(const GradescopePackage& options) {
  if (options.out.extension() != ".zip")
    throw BadInput("--out " + options.out.string() + ": Gradescope takes a .zip; give it such a name");
  Course course = read_course(HAIR_EXERCISES_JSON, options.course);
  if (!options.checks_only || !options.hand_in.empty())
    course.of_hand_in = read_hand_in(course, options.course, options.hand_in).rules.exercises;
  const HandoutSources sources{HAIR_SOURCE_DIR, HAIR_GOLDEN_DIR};
  write_gradescope_package(sources, options.checks_only ? "" : read_secret(options.secret), course, options);
  std::cout << options.out.string() << "\n";
  if (!options.checks_only) std::cout << advice_for_gradescope(course, options.minutes) << "\n";
  return 0;
}

int package_for_prairielearn(const PrairieLearnCourse& options) {
  write_prairielearn_course(read_secret(options.secret), read_course(HAIR_EXERCISES_JSON, options.course),
                            options);
  std::cout << options.out.string() << "\n";
  return 0;
}

}  // namespace

Command add_handout(CLI::App& hairgrade) {
  const auto options = std::make_shared<HandoutOptions>();
  CLI::App* command = hairgrade.add_subcommand("handout", "Make the archive that students get");
  needed_elsewhere(command->add_option("--out", options->out, "The archive, a .tar.gz"), options->out,
                   kHandout);
  if_there(options->course, kCourseFile);
  command->add_option("--course", options->course, "The course file: roles and points of the exercises");
  command->add_flag("--accept", options->accept,
                    "Accept the handout's files as they are now: write handout/packed.txt");
  return {command, [options] { return handout(*options); }};
}

Command add_package(CLI::App& hairgrade) {
  const auto options = std::make_shared<GradescopePackage>();
  CLI::App* command = hairgrade.add_subcommand("package", "Make what a platform grades with");
  command->require_subcommand(1);
  CLI::App* gradescope = command->add_subcommand("gradescope", "Make Gradescope's autograder.zip");
  gradescope->add_option("--out", options->out, "The archive, a .zip")->required();
  if_there(options->course, kCourseFile);
  gradescope->add_option("--course", options->course, "The course file: roles and points of the exercises");
  gradescope->add_option("--hand-in", options->hand_in,
                         "The hand-in of the course file's \"hand_ins\" that is graded there");
  gradescope->add_option("--secret", options->secret,
                         "A file with the staff's secret (default: ~/.config/hairgrade/secret)");
  gradescope
      ->add_option("--minutes", options->minutes, "The time limit that is set on Gradescope (default: 10)")
      ->check(CLI::Range(2, 40));
  gradescope->add_flag(
      "--checks-only", options->checks_only,
      "For the days before the deadline: the public checks, without points, secret and reference");
  const auto questions = std::make_shared<PrairieLearnCourse>();
  CLI::App* prairielearn = command->add_subcommand("prairielearn", "Make a question of each exercise");
  prairielearn->add_option("--out", questions->out, "A new folder")->required();
  if_there(questions->course, kCourseFile);
  prairielearn->add_option("--course", questions->course, "The course file: roles of the exercises");
  prairielearn->add_option("--secret", questions->secret,
                           "A file with the staff's secret (default: ~/.config/hairgrade/secret)");
  prairielearn->add_option("--image", questions->image, "The container's image in your private registry")
      ->required();
  return {command, [options, questions, prairielearn] {
            return prairielearn->parsed() ? package_for_prairielearn(*questions)
                                          : package_for_gradescope(*options);
          }};
}

}  // namespace grader::tool
