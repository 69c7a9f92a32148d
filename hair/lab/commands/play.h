// What `hairlab run` and `hairlab scenes` do, without how their command line is read: the headers of scenes and those of
// command lines take seconds to compile, so no file includes both.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace hair {

struct PlayOptions {
  std::string scene;          // a file, or the name of one that comes along
  std::filesystem::path out;  // a folder; empty: explain alone
  std::optional<int> frames;  // after the first, instead of the scene's
  bool explain = false, no_render = false;
};

// Both return what the program is to return.
int play_scene(const PlayOptions& options);
int list_scenes();

}  // namespace hair
