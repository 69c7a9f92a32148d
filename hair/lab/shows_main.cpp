// hairlab-show: hairlab's commands that show solvers and methods at work, in a second.
#include "hair/lab/commands/command.h"

int main(int argc, char* argv[]) {
  CLI::App app("hairlab-show: what hairlab shows the first exercises with");
  return hair::run_program(app, {hair::add_bowl_command(app), hair::add_phase_command(app)}, argc, argv);
}
