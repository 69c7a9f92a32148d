#include "hair/lab/commands/command.h"
#include "hair/lab/commands/play.h"

namespace hair {

Command add_scenes_command(CLI::App& program) {
  return {program.add_subcommand("scenes", "List the scenes that come along"), list_scenes};
}

}  // namespace hair
