#include <memory>

#include "hair/lab/commands/study_shell.h"
#include "hair/lab/phase/phase_plane.h"

namespace hair {

namespace {

int show_phase_plane(const ShellOptions& options, const Course& course) {
  if (!course.has("P1"))
    throw BadInput("this course leaves out P1, the four methods; there is nothing to show");
  StudyShell shell(options, "hairlab phase", "phase.json", {"index.html", "phase.csv"},
                   WhenInterrupted::loses);
  const std::vector<phase::Motion> motions = phase::phase_plane();
  shell.keep(phase::phase_json(motions), phase::phase_page(motions),
             {{"phase.csv", phase::phase_rows(motions)}});
  return shell.end(true);
}

}  // namespace

Command add_phase_command(CLI::App& program) {
  const auto options = std::make_shared<ShellOptions>();
  CLI::App* app = program.add_subcommand(kPhasePlane.name, kPhasePlane.what);
  app->add_option("--out", options->out, "The folder for page, table and record")->required();
  return {app, [options](const Course& course) { return show_phase_plane(*options, course); }};
}

}  // namespace hair
