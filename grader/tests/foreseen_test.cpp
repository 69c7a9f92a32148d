// STAFF ONLY. Tests that students can foresee each loss: a category has public checks, and a failure points
// to one of its rows. The definition HAIR_CHECKS names the folder of the programs reference_ID_check.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "grader/course/course.h"
#include "grader/judge/cases/suite_table.h"
#include "hair/io/files/temporary_folder.h"
#include "handout/check/category.h"

namespace grader {
namespace {

constexpr int kMostRows = 3;

// GoogleTest's list of the public checks.
nlohmann::json checks_of(const std::string& exercise) {
  const hair::TemporaryFolder folder("foreseen");
  const std::string report = (folder.path() / "report.json").string();
  const std::string command = std::string(HAIR_CHECKS) + "/reference_" + exercise +
                              "_check --gtest_list_tests --gtest_output=json:'" + report + "' >/dev/null";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  std::ifstream in(report);
  return nlohmann::json::parse(in)["testsuites"];
}

TEST(PublicChecks, ForeseeEachCategory) {
  for (const Exercise& exercise :
       read_course(std::string(HAIR_PROJECT) + "/handout/exercises.json").exercises) {
    const std::vector<checks::Category>& declared = declared_categories(exercise.id);
    std::map<std::string, std::set<std::string>> all;  // checks, by category
    for (const auto& suite : checks_of(exercise.id)) {
      const checks::Category* category = checks::category_of(declared, suite["name"]);
      ASSERT_NE(category, nullptr) << exercise.id << ": " << suite["name"] << " is no category";
      for (const auto& check : suite["testsuite"]) {
        const std::string name = check["name"];
        all[category->id].insert(name.substr(0, name.find('/')));
      }
    }
    for (const checks::Category& category : declared) {
      const std::string where = exercise.id + "/" + category.id;
      EXPECT_EQ(all.contains(category.id), !category.functions.empty()) << where << ": public checks";
      EXPECT_LE(std::ranges::count_if(category.rows, [](const auto& row) { return !row.look.empty(); }),
                kMostRows)
          << where;
      for (const checks::Row& row : category.rows) {
        EXPECT_EQ(row.checks.empty(), &row == &category.rows.front()) << where << ", row " << row.id;
        for (const std::string& check : row.checks)
          EXPECT_EQ(all[category.id].erase(check), 1U)
              << where << ", row " << row.id << ": no check " << check << ", or it has another row, too";
      }
    }
  }
}

TEST(Categories, AreWorthTheExercisesPointsAndAreAsked) {
  for (const Exercise& exercise :
       read_course(std::string(HAIR_PROJECT) + "/handout/exercises.json").exercises) {
    double sum = 0;
    for (const checks::Category& one : declared_categories(exercise.id)) sum += one.points;
    EXPECT_EQ(sum, exercise.points) << exercise.id;
    EXPECT_GE(categories(exercise.id).size(), 5U) << exercise.id;
  }
}

}  // namespace
}  // namespace grader
