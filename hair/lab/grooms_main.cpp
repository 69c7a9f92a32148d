// hairlab-groom: reads and writes grooms' files, and runs scenes with such files. hairlab starts it.
#include "hair/lab/commands/command.h"

int main(int argc, char* argv[]) {
  CLI::App app("hairlab: grooms, and scenes with files of grooms");
  const std::vector<hair::Command> commands = {hair::add_run_command(app), hair::add_scenes_command(app),
                                               hair::add_info_command(app), hair::add_convert_command(app),
                                               hair::add_groom_command(app)};
  return hair::run_program(app, commands, argc, argv);
}
