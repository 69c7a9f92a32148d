// STAFF ONLY. Tests the grader's part of a course file.
#include "grader/course/course.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "grader/course/input.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_refusal.h"

namespace grader::inline course {
namespace {

using tests::says;

Course read(const std::string& text) {
  const hair::TemporaryFolder folder{"course"};
  const std::filesystem::path file = folder.path() / "course.json";
  std::ofstream(file) << text;
  return read_course(HAIR_EXERCISES_JSON, file);
}

// Returns the error, or "".
std::string complaint(const std::string& text) {
  return tests::refusal<BadInput>([&] { read(text); });
}

TEST(CourseFile, ChangesTheBudgetOfASubmission) {
  const Course course = read(R"({"exercises": {}, "budget": {"idle_seconds": 4.5}})");
  EXPECT_EQ(course.budget.idle_seconds, 4.5);
  EXPECT_EQ(course.budget.worker_cpu_seconds, Budget().worker_cpu_seconds);
  EXPECT_FALSE(course.partial);
  EXPECT_TRUE(says(complaint(R"({"exercises": {}, "budget": {"idle": 4}})"), "idle"));
  EXPECT_TRUE(says(complaint(R"({"exercises": {}, "budget": {"idle_seconds": 0}})"), "budget.idle_seconds"));
  for (const BudgetField& field : budget_fields())
    EXPECT_EQ(complaint("{\"exercises\": {}, \"budget\": {\"" + std::string(field.key) + "\": 7}}"), "");
}

TEST(CourseFile, SaysWhetherPartsOfACategoryCount) {
  EXPECT_TRUE(read(R"({"exercises": {}, "partial": true})").partial);
  EXPECT_TRUE(says(complaint(R"({"exercises": {}, "partial": 1})"), "partial"));
}

TEST(CourseFile, ChangesItsExercises) {
  const Course course = read(R"({"exercises": {"H10": {"role": "absent"}, "S2": {"points": 2.5}}})");
  EXPECT_EQ(course.find("H10")->role, Role::absent);
  EXPECT_EQ(course.find("S2")->points, 2.5);
}

// With all exercises a share of the compiler's time still suffices for the largest honest file on a busy
// machine, twice.
TEST(Budget, HasRoomForAllExercises) {
  const int parts = static_cast<int>(read_course(HAIR_EXERCISES_JSON).exercises.size());
  EXPECT_GE(share_of(Budget(), parts).compiler_cpu_seconds, 10);
}

TEST(Budget, IsSharedOutAndUsedUp) {
  const Budget share = share_of(Budget(), 10);
  EXPECT_DOUBLE_EQ(share.idle_seconds, Budget().idle_seconds / 10);
  Budget spent = nothing_spent();
  EXPECT_EQ(used_up(spent, share), nullptr);
  for (const BudgetField& field : budget_fields()) {
    spent.*field.value = share.*field.value;
    EXPECT_EQ(used_up(spent, share), nullptr);
    spent.*field.value *= 1.01;
    EXPECT_STREQ(used_up(spent, share), field.name);
    spent.*field.value = 0;
  }
}

}  // namespace
}  // namespace grader::course
