// STAFF ONLY. Tests that results.json keeps Gradescope's rules, whatever is in it.
#include "grader/report/results_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "grader/report/facts/sample_results.h"
#include "grader/report/gradescope_rules.h"
#include "solver/test_refusal.h"

namespace grader::inline report {
namespace {

using tests::says;

using Json = nlohmann::json;

const ResultsOptions kAllOptions{.pictures = true, .student = "4711", .handed_in = "2026-03-04"};

std::string in_words(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

TEST(ResultsJson, KeepsThePlatformsRules) {
  std::vector<SubmissionResult> results = sample_class(30);
  for (const SubmissionResult& one : class_of_ten_exercises(10)) results.push_back(one);
  results.push_back({});
  for (const SubmissionResult& result : results)
    for (const ResultsOptions& options : {ResultsOptions{}, kAllOptions})
      EXPECT_EQ(in_words(broken_rules(student_json(result, options))), "") << result.name;
}

// Each exercise has one picture; a hundred of them don't fit.
SubmissionResult with_pictures(int of_each) {
  const PictureResult picture = sample_picture("0.50 s", 5);
  SubmissionResult result = class_of_ten_exercises(1).front();
  for (ExerciseResult& exercise : result.exercises) {
    exercise.pictures.assign(of_each, picture);
    exercise.cases = {{.name = kRunTitle}};
    exercise.points = 0;
  }
  return result;
}

TEST(ResultsJson, PicturesAreInsideAndTheTextStandsWithoutThem) {
  const std::string with = student_json(with_pictures(3), kAllOptions);
  EXPECT_TRUE(says(with, "data:image/png;base64,"));
  EXPECT_FALSE(says(student_json(with_pictures(3)), "data:image"));
  EXPECT_EQ(in_words(broken_rules(with)), "");
}

TEST(ResultsJson, PicturesGoWhereTheyWouldBreakTheBound) {
  ResultsOptions without = kAllOptions;
  without.pictures = false;
  const SubmissionResult many = with_pictures(100);
  EXPECT_EQ(student_json(many, kAllOptions), student_json(many, without));
}

// A compiler's messages on one file are 64 KiB at most; in ASCII a letter of two bytes takes six.
TEST(ResultsJson, TextsOfAnyLengthKeepTheBound) {
  std::string long_text;
  while (long_text.size() < (64 << 10)) long_text += "é\n\"<";
  SubmissionResult result;
  for (int i = 0; i < 14; ++i) {
    ExerciseResult exercise = sample_class(1).front().exercises.front();
    exercise.id = "H" + std::to_string(i);
    exercise.compiler_messages = long_text;
    result.exercises.push_back(exercise);
  }
  EXPECT_EQ(in_words(broken_rules(student_json(result, kAllOptions))), "");
}

}  // namespace
}  // namespace grader::report
