// hairlab-study: hairlab's commands that study how well scenes are played, and solvers solve.
#include "hair/lab/commands/program.h"

int main(int argc, char* argv[]) {
  CLI::App app("hairlab-study: what hairlab's studies run in");
  const std::vector<hair::Command> commands = {
      hair::add_solver_command(app), hair::add_stability_command(app), hair::add_study_command(app),
      hair::add_models_command(app), hair::add_validate_command(app)};
  return hair::run_program(app, commands, argc, argv);
}
