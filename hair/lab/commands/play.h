// `hairlab`, `hairlab run`, `hairlab view` and `hairlab scenes` without their command lines: the headers of
// scenes and those of command lines take seconds to compile, so no file includes both.
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

// Replaces a run's name: the reference's run of the same scene, which is part of the handout
// (reference/golden/make_motion.cpp). A folder of this name is ./reference.
inline constexpr const char* kReference = "reference";

struct ViewOptions {
  std::string run,
      other;                  // the folder of a run, or a scene as above; other: "" for none, or kReference
  std::filesystem::path out;  // empty: view.html in the run's folder, or NAME.html for a scene
};

// If not all exercises of a scene are written, shows the reference's run. Returns the program's exit code.
int view_runs(const ViewOptions& options, const Course& course);

}  // namespace hair
