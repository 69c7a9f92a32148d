// STAFF ONLY. `hairgrade handout`: makes the archive for students.
#include "grader/package/handout.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "grader/course/course.h"
#include "grader/course/input.h"
#include "grader/tool/commands/command.h"
#include "grader/tool/commands/course_folder.h"

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

}  // namespace grader::tool
