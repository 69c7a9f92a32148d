// STAFF ONLY. What a class's numbers say, on classes whose numbers are known beforehand.
#include "grader/report/class_statistics.h"

#include <gtest/gtest.h>

#include <numeric>

#include "grader/report/pages.h"

namespace grader {
namespace {

// One exercise of two points; each category that `passes` says gives one.
SubmissionResult person(const std::string& name, std::vector<bool> passes) {
  SubmissionResult result;
  result.name = name;
  ExerciseResult exercise;
  exercise.id = "S1";
  exercise.status = Status::partly;
  exercise.max_points = static_cast<double>(passes.size());
  for (const bool passed : passes) {
    CaseResult one;
    one.name = "A category";
    one.status = passed ? Status::passed : Status::wrong;
    one.points = passed;
    one.max_points = 1;
    exercise.points += one.points;
    exercise.cases.push_back(one);
  }
  result.exercises.push_back(exercise);
  return result;
}

// 0.27 * 11 = 2.97: three of eleven people are strong, and three are weak.
TEST(ClassStatistics, CategoriesTellStrongFromWeakPeople) {
  std::vector<SubmissionResult> results;
  for (int i = 0; i < 11; ++i) {
    const bool strong = i < 3, weak = i >= 8;
    // The first: strong people alone. The second: all. The third: weak people alone. Three more make strong people strong.
    results.push_back(person("p" + std::to_string(i), {strong, true, weak, !weak, !weak, !weak}));
  }
  for (const CategoryStatistics& category : category_statistics(results)) {
    ASSERT_TRUE(category.discrimination) << category.number;
    const double expected = category.number == "S1.2" ? 0 : category.number == "S1.3" ? -1 : 1;
    EXPECT_EQ(*category.discrimination, expected) << category.number;
  }
  EXPECT_EQ(category_statistics(results).front().passed, 3U) << "the hardest first";
  results.resize(9);
  EXPECT_FALSE(category_statistics(results).front().discrimination);
}

TEST(ClassStatistics, EachPersonCountsOnce) {
  const std::vector<SubmissionResult> results{
      person("a", {false, false, false}), person("b", {true, false, false}), person("c", {true, true, true})};
  const std::vector<ExerciseStatistics> exercises = exercise_statistics(results);
  ASSERT_EQ(exercises.size(), 1U);
  EXPECT_EQ(exercises[0].tenths, (Tenths{1, 0, 0, 1, 0, 0, 0, 0, 0, 1}));
  EXPECT_EQ(exercises[0].tenths, tenths_of_totals(results));
  EXPECT_EQ(std::accumulate(exercises[0].points.begin(), exercises[0].points.end(), 0.0), 4);
}

// Somebody who loses one category, or all, says nothing; two people are no group.
TEST(ClassStatistics, WhoFailAlikeIsNamed) {
  std::vector<SubmissionResult> results;
  for (const char* name : {"a", "b", "c"}) results.push_back(person(name, {true, false, false}));
  for (const char* name : {"d", "e", "f"}) results.push_back(person(name, {true, true, false}));
  for (const char* name : {"g", "h", "i"}) results.push_back(person(name, {false, false, false}));
  for (const char* name : {"j", "k"}) results.push_back(person(name, {false, true, false}));
  const std::vector<FailAlike> groups = who_fail_alike(results);
  ASSERT_EQ(groups.size(), 1U);
  EXPECT_EQ(groups[0].people, (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_EQ(groups[0].categories, (std::vector<std::string>{"S1.2", "S1.3"}));
}

// A broken archive is one person, who stands in no list of exercises.
TEST(ClassStatistics, ThePageCountsPeopleAndNotCells) {
  SubmissionResult broken = person("broken", {});
  broken.note = "This is no archive.";
  ExerciseResult unread;
  unread.id = "S1";
  unread.status = Status::unreadable;
  broken.exercises.assign(14, unread);
  const std::string page = class_page({broken, person("b", {true, false})});
  EXPECT_NE(page.find("could not be taken</span> 1"), std::string::npos);
  const std::string status = badge(Status::unreadable).text + " 1";
  EXPECT_EQ(page.find(status), std::string::npos);
  broken.note.clear();
  EXPECT_NE(class_page({broken}).find(status + "</summary>"), std::string::npos)
      << "one person, with 14 exercises";
}

}  // namespace
}  // namespace grader
