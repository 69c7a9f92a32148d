// hairlab: plays scenes of hair with the exercises' code. How well they are played is studied by hairlab-study, to which
// it hands over. Its exit codes are in hair/lab/commands/exit_codes.h.
#include "hair/lab/commands/program.h"
#include "hair/lab/commands/studies.h"

int main(int argc, char* argv[]) {
  if (argc > 1 && hair::is_study(argv[1])) return hair::hand_over_to_studies(argv);
  CLI::App app("hairlab: plays scenes of hair with your code");
  const std::vector<hair::Command> commands = {hair::add_run_command(app),   hair::add_scenes_command(app),
                                               hair::add_info_command(app),  hair::add_convert_command(app),
                                               hair::add_groom_command(app), hair::add_draw_command(app)};
  for (const hair::StudyCommand& study : hair::kStudyCommands) app.add_subcommand(study.name, study.what);
  return hair::run_program(app, commands, argc, argv);
}
