// STAFF ONLY. Tests the suite as a classifier: wrong programs, made of the reference by one small change
// each, lose points. The environment's HAIR_EXERCISE names the exercise. Objects are kept: an interrupted
// test compiles nothing twice.
#include <gtest/gtest.h>

#include <filesystem>

#include "grader/grading/secret.h"
#include "grader/grading/settings_for_tests.h"
#include "grader/mutants/judging.h"
#include "grader/tests/mutants_found.h"
#include "grader/tests/run_program.h"

namespace grader {
namespace {

namespace fs = std::filesystem;

GradingSettings settings_for(const std::string& exercise) {
  GradingSettings settings = settings_for_tests();
  settings.exercise = exercise;
  settings.cache = fs::path(HAIR_GRADED) / "mutants";
  settings.secret = read_secret(HAIR_TEST_SECRET);
  fs::create_directories(settings.cache);
  return settings;
}

TEST(Suite, TakesPointsOfEachWrongProgram) {
  const std::string id = environment("HAIR_EXERCISE", "");
  const GradingSettings settings = settings_for(id);
  const Exercise* exercise = settings.course.find(id);
  ASSERT_NE(exercise, nullptr) << "HAIR_EXERCISE must name an exercise; it is \"" << id << "\"";
  const Judging judging(settings);
  expect_mutants_found(
      *exercise,
      [&](const std::string& name, const std::string& source) { return judging.judge(name, source); },
      "Write a case that finds it, or its reason into reference/<ID>/equivalents.json");
}

}  // namespace
}  // namespace grader
