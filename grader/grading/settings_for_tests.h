// STAFF ONLY. The settings of grading in tests: the parts of this build, and the course as the handout has
// it. The program's target says where they are (HAIR_PROJECT, HAIR_KIT_DIR, HAIR_SUITE, HAIR_RUNNERS,
// HAIR_HIDDEN_SCENES).
#pragma once

#include <filesystem>

#include "grader/grading/suite_jobs.h"
#include "grader/sandbox/isolation_for_tests.h"

namespace grader::inline grading {

// The caller sets the cache and the secret.
inline GradingSettings settings_for_tests() {
  GradingSettings settings;
  settings.course = read_course(std::filesystem::path(HAIR_PROJECT) / "handout/exercises.json");
  settings.kit = HAIR_KIT_DIR;
  settings.suite = HAIR_SUITE;
  settings.runners = HAIR_RUNNERS;
  settings.scenes = HAIR_HIDDEN_SCENES;
  settings.isolation = isolation_for_tests();
  settings.reference = std::filesystem::path(HAIR_PROJECT) / "reference";
  return settings;
}

}  // namespace grader::grading
