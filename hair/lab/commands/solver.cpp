#include <memory>

#include "hair/lab/commands/study_shell.h"
#include "hair/lab/run/stub.h"
#include "hair/lab/solver/solver_record.h"
#include "solver/linearSolver.h"
#include "solver/normal_equations.h"

namespace hair {

using namespace solver_lab;

namespace {

int run(const ShellOptions& options, const Course& course) {
  solver::study::Functions studied;
  if (course.has("S1")) studied.conj_grad = ConjGrad;
  if (course.has("S2")) studied.normal_equations = solve_normal_equations;
  if (!studied.conj_grad) throw BadInput("this course leaves out S1, ConjGrad; there is no solver to study");
  StudyShell shell(options, "hairlab solver", "solver.json",
                   {"index.html", "convergence.csv", "direct.csv", "iterations.csv", "digits.csv"},
                   WhenInterrupted::loses);
  solver::study::Settings settings;
  settings.quick = options.quick;
  const auto study = solver::study::study_solvers(studied, settings, shell.interrupted(), shell.teller());
  if (!study) return shell.end(false);
  const std::string left_out = study->not_written         ? missing_part(*study->not_written)
                               : studied.normal_equations ? ""
                                                          : "this course has no S2";
  std::vector<solver::study::Compared> all;
  for (const auto* family : {&study->conditions, &study->strands})
    all.insert(all.end(), family->begin(), family->end());
  shell.keep(solver_json(*study, left_out), solver_page(*study, left_out),
             {{"convergence.csv", convergence_rows(all)},
              {"direct.csv", direct_rows(all)},
              {"iterations.csv", rows_of(study->needed, row_of_needed)},
              {"digits.csv", rows_of(study->digits, row_of_digits)}});
  return shell.end(true, left_out.empty() ? "" : "\nwithout the normal equations: " + left_out);
}

}  // namespace

Command add_solver_command(CLI::App& program) {
  const auto options = std::make_shared<ShellOptions>();
  CLI::App* app = add_study(program, kSolverStudy, *options, "fewer points, and shorter repeats");
  return {app, [options](const Course& course) { return run(*options, course); }};
}

}  // namespace hair
