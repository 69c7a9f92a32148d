// STAFF ONLY. Tests the points of an exercise that is right in some of its cases, with and without "partial"
// in the course file; and that the reference is graded before all others.
#include "grader/grading/exercise_grading.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "grader/grading/grading.h"
#include "grader/grading/settings_for_tests.h"
#include "hair/io/files/temporary_folder.h"

namespace grader::inline grading {
namespace {

namespace fs = std::filesystem;

const fs::path kProject = HAIR_PROJECT;

// Makes the reference's S1 wrong for an even number of unknowns.
std::string right_for_odd_n() {
  std::ostringstream text;
  text << "#define ConjGrad right\n"
       << std::ifstream(kProject / "reference/S1/conj_grad.cpp").rdbuf()
       << "#undef ConjGrad\n"
          "double ConjGrad(int n, implicitMatrix* A, double x[], double b[], double epsilon, int* steps) {\n"
          "  const double value = right(n, A, x, b, epsilon, steps);\n"
          "  if (n > 0 && n % 2 == 0) x[0] += 1;\n"
          "  return value;\n"
          "}\n";
  return text.str();
}

GradingSettings settings_without_images() {
  GradingSettings settings = settings_for_tests();
  settings.cache = HAIR_TEST_CACHE;
  settings.secret = "a secret for tests alone";
  settings.images = false;
  return settings;
}

class PartialPoints : public testing::Test {
 protected:
  ExerciseResult grade(bool partial) const {
    GradingSettings settings = settings_without_images();
    settings.course.partial = partial;
    settings.isolation = Isolation::none;
    const Exercise& s1 = *settings.course.find("S1");
    const StagedKit kit(settings.kit, settings.course);
    const Compiler compiler(kit, settings.cache, Isolation::none);
    const SuiteJobs jobs(settings, kit);
    Submission submission;
    submission.name = "somebody";
    submission.files[s1.file].text = right_for_odd_n();
    ExerciseResult result = describe(s1);
    ExerciseTiming timing;
    grade_exercise(jobs, compiler, s1, submission, kit.new_job("job"), 30, result, timing);
    return result;
  }
};

// A worker that does not run on this machine must cost no student a point: no submission is graded.
TEST(Reference, IsGradedFirst) {
  const hair::TemporaryFolder folder("kit");
  GradingSettings settings = settings_without_images();
  settings.kit = folder.path() / "kit";
  fs::copy(HAIR_KIT_DIR, settings.kit, fs::copy_options::recursive);
  std::ofstream(settings.kit / "worker") << "#!/bin/no/such/shell\n";
  settings.exercise = "S1";
  try {
    const Grading grading(settings);
    FAIL() << "the reference is not asked";
  } catch (const std::runtime_error& why) {
    const std::string said = why.what();
    EXPECT_TRUE(said.starts_with("the reference fails its own suite for S1, in \"Systems\"")) << said;
    EXPECT_NE(said.find("the worker says: "), std::string::npos) << said;
  }
}

TEST(WholePoints, AreThoseOfFractions) {
  for (const int points : {1, 5, 18, 20, 32})
    for (int weights = 1; weights <= 60; ++weights)
      for (int weight = 1; weight <= weights; ++weight)
        for (const int cases : {1, 3, 7, 12})
          for (int held = 0; held <= cases; ++held)
            ASSERT_EQ(whole_points(points, weight, weights, held, cases),
                      points * weight * held / (weights * cases))
                << points << " points, " << weight << "/" << weights << ", " << held << " of " << cases;
  EXPECT_EQ(whole_points(7.5, 2.5, 7.5, 12, 12), 2);
  EXPECT_EQ(whole_points(1e6, 99, 100, 1000, 1000), 990000);
}

TEST_F(PartialPoints, AreAllOrNothingWithoutTheKey) {
  const ExerciseResult result = grade(false);
  int wrong = 0;
  for (const CaseResult& one : result.cases) {
    EXPECT_EQ(one.points, one.status == Status::passed ? one.max_points : 0) << one.name;
    wrong += one.cases > 0;
  }
  EXPECT_GT(wrong, 0) << "cases are counted";
}

TEST_F(PartialPoints, AreTheShareOfCasesThatHoldInWholePoints) {
  const ExerciseResult result = grade(true);
  int parts = 0;
  double sum = 0;
  for (const CaseResult& one : result.cases) {
    SCOPED_TRACE(one.name + ": " + std::to_string(one.held) + " of " + std::to_string(one.cases));
    if (one.status == Status::passed) {
      EXPECT_EQ(one.points, one.max_points);
    } else if (one.cases > 0) {
      const double share = one.max_points * one.held / one.cases;
      EXPECT_EQ(one.points, std::trunc(one.points));
      EXPECT_LE(one.points, share);
      EXPECT_GT(one.points, share - 1);
      parts += one.points > 0 && one.points < one.max_points;
    } else {
      EXPECT_EQ(one.points, 0);
    }
    sum += one.points;
  }
  EXPECT_GT(parts, 0) << "a category gives a part of its points";
  EXPECT_EQ(result.points, sum);
}

}  // namespace
}  // namespace grader::grading
