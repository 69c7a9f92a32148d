// STAFF ONLY. hairgrade's two commands for Gradescope: what its container runs, and the package that brings it there.
#pragma once

#include <filesystem>

#include "grader/package/gradescope_package.h"
#include "grader/tool/grade_settings.h"

namespace grader {

struct GradescopeOptions {
  std::filesystem::path folder;
  bool leaderboard = false;
  GradeSettings settings;
};

// Both return hairgrade's exit code. The first leaves results.json whatever happens, and throws what has happened.
int grade_on_gradescope(const GradescopeOptions& options);
int package_for_gradescope(const GradescopePackage& options);

}  // namespace grader
