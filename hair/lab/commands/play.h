// `hairlab`, `hairlab run` and `hairlab scenes` without their command lines: the headers of scenes and
// those of command lines take seconds to compile, so no file includes both.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace hair {

struct Course;

struct PlayOptions {
  std::string scene;          // a file, or the name of a shipped scene
  std::filesystem::path out;  // a folder; empty: only explain
  std::optional<int> frames;  // after the first one; overrides the scene's number
  bool explain = false, no_render = false;
  int jobs = 1;         // threads; 0: as many as there are processors
  bool strict = false;  // warnings make the exit code kBroke
};

// For a call of hairlab without a command: the exercises that are not written yet, and the scenes that run
// without them.
void show_overview(const Course& course);

// All return the program's exit code.
int play_scene(const PlayOptions& options, const Course& course);
int list_scenes(const Course& course);
int list_keys();  // the keys of scenes

}  // namespace hair
