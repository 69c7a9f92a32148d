#include <memory>

#include "hair/lab/bowl/bowl_page.h"
#include "hair/lab/commands/study_shell.h"
#include "hair/lab/phase/phase_plane.h"
#include "hair/lab/run/stub.h"
#include "solver/linearSolver.h"
#include "solver/normal_equations.h"

namespace hair {

namespace {

int show_bowl(const ShellOptions& options, const Course& course) {
  if (!course.has("S1")) throw BadInput("this course leaves out S1, ConjGrad; there is nothing to show");
  StudyShell shell(options, "hairlab bowl", "bowl.json", {"index.html", "bowl.csv"}, WhenInterrupted::loses);
  std::vector<solver::study::BowlPath> paths = {solver::study::symmetric_path(ConjGrad)};
  std::string left_out;
  if (!course.has("S2")) {
    left_out = "this course has no S2";
  } else {
    try {
      paths.push_back(solver::study::normal_path(solve_normal_equations));
    } catch (const NotImplemented& stub) {
      left_out = missing_part(stub);
    }
  }
  const std::vector<Row> rows = bowl::bowl_rows(paths);
  shell.keep({{"format", 1}, {"left_out", Value(if_any(left_out)).json()}, {"paths", json_of(rows)}},
             bowl::bowl_page(paths, left_out), {{"bowl.csv", rows}});
  return shell.end(true, left_out.empty() ? "" : "\nwithout the normal equations: " + left_out);
}

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

Command add_show(CLI::App& program, const OtherCommand& command,
                 int (*show)(const ShellOptions&, const Course&)) {
  const auto options = std::make_shared<ShellOptions>();
  CLI::App* app = program.add_subcommand(command.name, command.what);
  app->add_option("--out", options->out, "The folder for page, table and record")->required();
  return {app, [options, show](const Course& course) { return show(*options, course); }};
}

}  // namespace

Command add_bowl_command(CLI::App& program) {
  return add_show(program, kBowl, show_bowl);
}

Command add_phase_command(CLI::App& program) {
  return add_show(program, kPhasePlane, show_phase_plane);
}

}  // namespace hair
