// STAFF ONLY. Tests how many different things a student can see of a result, that nothing is finer, and
// points in words.
#include "grader/report/facts/student_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "grader/report/facts/sample_results.h"
#include "grader/report/facts/text.h"
#include "grader/report/pages/pages.h"
#include "grader/report/results_json.h"
#include "hair/io/image/read_png.h"
#include "solver/test_refusal.h"

namespace grader::inline report {
namespace {

using tests::says;

ExerciseResult exercise_with(const std::vector<Status>& statuses) {
  ExerciseResult exercise;
  for (const Status status : statuses)
    exercise.cases.push_back({"a category", status, 0, 5, "feedback of " + to_string(status), "detail"});
  return exercise;
}

TEST(StudentView, HasThreeKindsOfCategories) {
  std::set<std::pair<Status, std::string>> seen;
  for (const Status status : all_statuses)
    for (const Status other : {Status::passed, Status::wrong}) {
      SubmissionResult result{.exercises = {exercise_with({status, other})}};
      const SubmissionResult view = for_student(result);
      for (const CaseResult& one : view.exercises[0].cases) {
        seen.insert({one.status, one.feedback});
        EXPECT_EQ(one.detail, "");
        EXPECT_EQ(one.max_points, 5);
      }
    }
  EXPECT_EQ(seen.size(), 3u);
}

// A wrong category has one of four sentences; one with few cases always has the same.
TEST(StudentView, TellsInBandsHowManyCasesHold) {
  const auto said = [](int cases, int held) {
    SubmissionResult result{.exercises = {exercise_with({Status::wrong, Status::passed})}};
    CaseResult& one = result.exercises[0].cases[0];
    one.cases = cases;
    one.held = held;
    const CaseResult view = for_student(result).exercises[0].cases[0];
    EXPECT_EQ(view.cases + view.held, 0) << "numbers are for staff";
    return view.feedback;
  };
  std::set<std::string> seen;
  for (int cases = 0; cases <= 40; ++cases)
    for (int held = 0; held < std::max(cases, 1); ++held) {
      seen.insert(said(cases, held));
      if (cases < 5) {
        EXPECT_EQ(said(cases, held), said(0, 0));
      }
    }
  EXPECT_EQ(seen.size(), 4u);
  // Tests each band at its ends: four fifths, a fifth.
  for (const int held : {16, 19}) EXPECT_TRUE(says(said(20, held), "nearly all")) << held;
  for (const int held : {4, 15}) EXPECT_TRUE(says(said(20, held), "some")) << held;
  for (const int held : {0, 3}) EXPECT_TRUE(says(said(20, held), "hardly any")) << held;
}

TEST(StudentView, CallsAStubAStub) {
  SubmissionResult result{.exercises = {exercise_with({Status::not_implemented, Status::not_implemented})}};
  EXPECT_EQ(for_student(result).exercises[0].cases[1].status, Status::not_implemented);
}

TEST(StudentView, TellsWhatNumbersLookLike) {
  SubmissionResult result{.exercises = {exercise_with({Status::wrong, Status::passed})}};
  result.exercises[0].cases[0].hint = "It is right but for signs of some entries.";
  const CaseResult view = for_student(result).exercises[0].cases[0];
  EXPECT_EQ(view.feedback, "Not right. It is right but for signs of some entries.");
  EXPECT_EQ(view.hint, "");
  EXPECT_TRUE(says(staff_page(result), "It is right but for signs"));
}

// Sentences and details of the suite, and the output of compiler, linker and worker, stay with the staff.
TEST(StudentView, IsWhatStudentsGet) {
  SubmissionResult result = sample_class(1).front();
  for (ExerciseResult& exercise : result.exercises)
    for (CaseResult& one : exercise.cases) one.feedback = one.detail = "SUITESAYS";
  EXPECT_FALSE(says(student_page(result), "SUITESAYS"));
  EXPECT_FALSE(says(student_json(result), "SUITESAYS"));
  EXPECT_TRUE(says(staff_page(result), "SUITESAYS"));
}

// Particles can spell anything; 48 coarse pixels in a row can't.
TEST(StudentView, DrawsCoarselyWhatIsFarOff) {
  SubmissionResult result;
  ExerciseResult exercise = exercise_with({Status::wrong});
  PictureResult picture = sample_picture("1 s", 5);
  picture.flip = 0.123456;
  exercise.pictures = {picture, picture};
  exercise.pictures[1].far_off = true;
  result.exercises = {exercise};
  const auto pictures = for_student(result).exercises[0].pictures;
  EXPECT_EQ(pictures[0].student, picture.student);
  EXPECT_EQ(pictures[0].flip, picture.flip);
  EXPECT_LE(hair::decode_png(pictures[1].student, "").width, 48);
  EXPECT_LE(hair::decode_png(pictures[1].heat, "").width, 48);
  EXPECT_EQ(pictures[1].reference, picture.reference);
  EXPECT_TRUE(says(student_page(result), "FLIP 0.123, 123 times the limit"));
}

TEST(ShownPoints, HaveTwoDecimalsAtMost) {
  EXPECT_EQ(shown_points(0), "0");
  EXPECT_EQ(shown_points(30), "30");
  EXPECT_EQ(shown_points(100), "100");
  EXPECT_EQ(shown_points(12.5), "12.5");
  EXPECT_EQ(shown_points(29.999999999999996), "30");
  EXPECT_EQ(shown_points(1.0 / 3), "0.33");
  EXPECT_EQ(shown_points(-1e-9), "0");
}

TEST(ShownTotal, HasNoZeroToReach) {
  EXPECT_EQ(shown_total(20, 200), "20 of 200 points");
  EXPECT_EQ(shown_total(15, 0), "15 points of extra credit");
}

}  // namespace
}  // namespace grader::report
