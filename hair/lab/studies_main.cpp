// hairlab-study: hairlab's commands that measure how well scenes run, and how well solvers solve.
#include "hair/lab/commands/command.h"

int main(int argc, char* argv[]) {
  CLI::App app("hairlab-study: what hairlab's studies run in");
  const hair::Command study = hair::add_study_command(app);
  // Commands of commands come first.
  const std::vector<hair::Command> commands = {
      hair::add_study_head_command(*study.app), hair::add_solver_command(app),
      hair::add_stability_command(app), study, hair::add_validate_command(app)};
  return hair::run_program(app, commands, argc, argv);
}
