#include <memory>

#include "hair/lab/commands/command.h"
#include "hair/lab/commands/play.h"

namespace hair {

Command add_scenes_command(CLI::App& program) {
  const auto keys = std::make_shared<bool>(false);
  CLI::App* app = program.add_subcommand("scenes", "List the scenes that come along");
  app->add_flag("--keys", *keys,
                "List all keys that a scene can have instead, with their bounds, as Markdown");
  return {app, [keys](const Course& course) { return *keys ? list_keys() : list_scenes(course); }};
}

}  // namespace hair
