#include <unistd.h>

#include <iostream>
#include <memory>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/write_file.h"
#include "hair/io/machine.h"
#include "hair/lab/commands/command.h"
#include "hair/lab/commands/hand_over.h"
#include "hair/lab/run/interruption.h"
#include "hair/lab/run/output_folder.h"
#include "hair/lab/solver/solver_page.h"
#include "hair/lab/solver/solver_record.h"
#include "hair/lab/solver/solver_tables.h"
#include "hair/lab/stub.h"
#include "solver/linearSolver.h"
#include "solver/normal_equations.h"

namespace hair {

using namespace solver_lab;

namespace {

struct SolverOptions {
  std::filesystem::path out;
  solver::study::Settings settings;
};

const OutputKind& solver_output() {
  static const OutputKind kind = {
      "hairlab solver",
      "solver.json",
      kSolverRecordBegin,
      {"index.html", "convergence.csv", "direct.csv", "iterations.csv", "digits.csv", "products.csv"}};
  return kind;
}

void write(const OutputFolder& folder, const solver::study::SolverStudy& study, const std::string& left_out) {
  const std::string machine = measured_on(this_machine());
  write_file(folder.now("solver.json"), solver_json(study, machine, left_out));
  for (const NamedTable& table : solver_tables(study))
    write_file(folder.now(table.file), to_csv(table.table));
  write_file(folder.now("index.html"), to_html(solver_page(study, machine, left_out)));
}

int run(const SolverOptions& options, const Course& course) {
  solver::study::Functions studied;
  if (course.has("S1")) studied.conj_grad = ConjGrad;
  if (course.has("S2")) studied.normal_equations = solve_normal_equations;
  if (!studied.conj_grad) throw BadInput("this course leaves out S1, ConjGrad; there is no solver to study");
  const std::atomic<bool>& interrupted = catch_interruption("\nhairlab: stopping; once more ends at once\n");
  OutputFolder folder(options.out, solver_output());
  const bool terminal = isatty(STDERR_FILENO) != 0;
  const auto say = [&](const std::string& what) {
    if (terminal) std::cerr << "\r\x1b[K" << what << std::flush;
  };
  std::optional<solver::study::SolverStudy> study;
  try {
    study = solver::study::study_solvers(studied, options.settings, interrupted, say);
  } catch (const NotImplemented&) {
    say("");
    throw;
  }
  say("");
  if (!study) {
    std::cerr << "hairlab: interrupted; nothing is written\n";
    return kInterrupted;
  }
  std::string left_out;
  if (study->not_written)
    left_out = missing_part(*study->not_written);
  else if (!studied.normal_equations)
    left_out = "this course has no S2";
  write(folder, *study, left_out);
  folder.keep();
  std::cout << (folder.path() / "index.html").string() << "\n";
  if (!left_out.empty()) std::cout << "without the normal equations: " << left_out << "\n";
  return 0;
}

}  // namespace

Command add_solver_command(CLI::App& program) {
  const auto options = std::make_shared<SolverOptions>();
  CLI::App* app = program.add_subcommand(kSolverStudy.name, kSolverStudy.what);
  app->add_option("--out", options->out, "The folder for page, JSON and CSV")->required();
  app->add_flag("--quick", options->settings.quick, "Fewer points, and shorter repeats");
  return {app, [options](const Course& course) { return run(*options, course); }};
}

}  // namespace hair
