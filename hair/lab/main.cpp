// hairlab: runs scenes of hair with the exercises' code. It hands over to hairlab-study, which measures the
// quality of runs, and to hairlab-groom, which reads grooms' files. Its exit codes are in
// hair/lab/commands/exit_codes.h.
#include "hair/groom/groom_file.h"
#include "hair/lab/commands/command.h"
#include "hair/lab/commands/hand_over.h"
#include "hair/lab/commands/play.h"

int main(int argc, char* argv[]) {
  const hair::OtherCommand* const other = argc > 1 ? hair::other_command(argv[1]) : nullptr;
  if (other) return hair::hand_over(other->program, other->name, argv);
  CLI::App app("hairlab: plays scenes of hair with your code");
  const std::vector<hair::Command> commands = {hair::add_run_command(app), hair::add_scenes_command(app),
                                               hair::add_view_command(app)};
  for (const hair::OtherCommand& one : hair::kOtherCommands) app.add_subcommand(one.name, one.what);
  try {
    return hair::run_program(app, commands, argc, argv, hair::show_overview);
  } catch (const hair::GroomFilesElsewhere& scene) {
    return hair::hand_over(hair::kGrooms, "the reader of " + scene.file, argv);
  }
}
