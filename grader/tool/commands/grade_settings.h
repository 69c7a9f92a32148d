// STAFF ONLY. hairgrade's options, and the settings of grading that follow from them in this build.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/course/isolation.h"
#include "grader/grading/suite_jobs.h"

namespace grader::inline tool {

struct GradeSettings {
  std::optional<std::filesystem::path> course, secret, cache;
  std::optional<std::string> exercise;
  std::vector<std::string> of_hand_in;  // its exercises; empty: all
  bool no_images = false, study = false;
  std::optional<Isolation> isolation;  // nothing: the best kind on this machine
  int jobs = 1;
};

// Returns the parts of this build, the course, the secret, and this machine's isolation. Throws BadInput for
// a missing part, also for a machine that can't isolate.
GradingSettings settings_of(const GradeSettings& options);

}  // namespace grader::tool
