// `hairlab view` without its command line (play.h explains why).
#pragma once

#include <filesystem>
#include <string>

namespace hair {

struct Course;

// Replaces a run's name: the reference's run of the same scene, which is part of the handout
// (reference/golden/make_motion.cpp). A folder of this name is ./reference.
inline constexpr const char* kReference = "reference";

struct ViewOptions {
  std::string run,
      other;  // the folder of a run, or a scene as PlayOptions has it; other: "" for none, or kReference
  std::filesystem::path out;  // empty: view.html in the run's folder, or NAME.html for a scene
};

// If not all exercises of a scene are written, shows the reference's run. Returns the program's exit code.
int view_runs(const ViewOptions& options, const Course& course);

}  // namespace hair
