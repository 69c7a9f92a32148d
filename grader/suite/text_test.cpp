// STAFF ONLY. What the assignment texts promise is what the suites grade: the same categories, the same
// points.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>

#include "grader/course/course.h"
#include "grader/suite/graded_categories.h"

namespace grader {
namespace {

struct Promise {
  double points = -1;                   // "30 points, in these categories"
  std::map<std::string, double> table;  // points by category
};

Promise promise_of(const std::filesystem::path& text) {
  static const std::regex total("(\\d+) points, in these categories.*"), row("\\| (.+?) \\| ([0-9.]+) \\|.*");
  std::ifstream in(text);
  EXPECT_TRUE(in) << text << " can't be read";
  Promise promise;
  bool in_table = false;
  std::smatch found;
  for (std::string line; std::getline(in, line);) {
    if (std::regex_match(line, found, total)) promise.points = std::stod(found[1]);
    in_table = line.starts_with("| category | points |") || (in_table && line.starts_with("|"));
    if (in_table && std::regex_match(line, found, row)) {
      EXPECT_TRUE(promise.table.emplace(found[1], std::stod(found[2])).second)
          << found[1] << " stands there twice";
    }
  }
  return promise;
}

TEST(AssignmentText, ListsTheCategoriesThatAreGradedWithTheirPoints) {
  const Course course = read_course(std::filesystem::path(HAIR_HANDOUT) / "exercises.json");
  ASSERT_FALSE(course.exercises.empty());
  for (const Exercise& exercise : course.exercises) {
    SCOPED_TRACE(exercise.text);
    std::map<std::string, double> graded;
    double sum = 0;
    for (const Category& category : graded_categories(exercise.id)) {
      graded[category.title] = category.weight;
      sum += category.weight;
    }
    const Promise promise = promise_of(std::filesystem::path(HAIR_HANDOUT) / exercise.text);
    EXPECT_EQ(promise.table, graded);
    EXPECT_EQ(promise.points, sum);
    EXPECT_EQ(exercise.points, sum);
  }
}

}  // namespace
}  // namespace grader
