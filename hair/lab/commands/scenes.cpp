#include <iostream>

#include "hair/files/bad_input.h"
#include "hair/files/printable.h"
#include "hair/lab/commands/command.h"
#include "hair/lab/shipped_scenes.h"
#include "hair/scene/scene.h"

namespace hair {

namespace {

int list_scenes() {
  for (const std::string& name : shipped_scenes(HAIR_SCENES_DIR)) try {
      const Scene scene = read_scene(find_scene(name, HAIR_SCENES_DIR));
      std::string exercises;
      for (const std::string& id : exercises_of(scene)) exercises += (exercises.empty() ? "" : ", ") + id;
      std::cout << name << ": " << printable(scene.shows, 200) << " (" << exercises << ")\n";
    } catch (const BadInput& error) {
      // One that needs what this course leaves out says so.
      std::cout << name << ": can't be played: " << error.what() << "\n";
    }
  return 0;
}

}  // namespace

Command add_scenes_command(CLI::App& program) {
  return {program.add_subcommand("scenes", "List the scenes that come along"), list_scenes};
}

}  // namespace hair
