// `hairlab view` without its command line (play.h says why).
#pragma once

#include <filesystem>
#include <string>

namespace hair {

struct Course;

struct ViewOptions {
  std::string run, other;     // the folder of a run, or a scene as PlayOptions has it; other: "" for none
  std::filesystem::path out;  // empty: view.html in the run's folder, or NAME.html for a scene
};

// Returns the program's exit code.
int view_runs(const ViewOptions& options, const Course& course);

}  // namespace hair
