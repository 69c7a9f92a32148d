// STAFF ONLY. What hairgrade's options ask for, and how this build grades then.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/compile/cache.h"
#include "grader/course/isolation.h"
#include "grader/tool/suite_jobs.h"

namespace grader::inline tool {

struct GradeSettings {
  std::optional<std::filesystem::path> course, secret, cache;
  std::optional<std::string> exercise;
  std::vector<std::string> of_hand_in;  // its exercises; empty: all
  bool no_images = false, study = false;
  std::uintmax_t cache_megabytes = kCacheBytes / 1'000'000;
  std::optional<Isolation> isolation;  // nothing: what this machine can give
  int jobs = 1;
};

// The parts of this build, the course, the secret, and how this machine isolates student code. Throws
// BadInput for what is missing, also for a machine that can't isolate.
GradingSettings settings_of(const GradeSettings& options);

}  // namespace grader::tool
