// STAFF ONLY. Tests that students can foresee each loss: a category has public checks, and a failure points
// to one of its rows. The definition HAIR_CHECKS names the folder of the programs reference_ID_check.
#include <gtest/gtest.h>

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

constexpr std::size_t kMostRows = 3;

// Returns the rows that checks point to, by their suites: the property "row" of GoogleTest's report on the
// reference; "": a check names no row.
std::map<std::string, std::set<std::string>> rows_by_suite(const std::string& exercise) {
  const hair::TemporaryFolder folder("foreseen");
  const std::string report = (folder.path() / "report.json").string();
  const std::string command = std::string(HAIR_CHECKS) + "/reference_" + exercise +
                              "_check --gtest_output=json:'" + report + "' >/dev/null";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  std::ifstream in(report);
  const nlohmann::json all = nlohmann::json::parse(in);
  std::map<std::string, std::set<std::string>> rows;
  for (const auto& suite : all["testsuites"])
    for (const auto& check : suite["testsuite"])
      rows[suite["name"]].insert(check.contains("row") ? check["row"].get<std::string>() : "");
  return rows;
}

TEST(PublicChecks, ForeseeEachCategory) {
  for (const Exercise& exercise :
       read_course(std::string(HAIR_PROJECT) + "/handout/exercises.json").exercises) {
    const std::vector<checks::Category>& declared = declared_categories(exercise.id);
    std::map<std::string, std::set<std::string>> asked;  // rows, by category
    for (const auto& [suite, rows] : rows_by_suite(exercise.id)) {
      const checks::Category* category = checks::category_of(declared, suite);
      ASSERT_NE(category, nullptr) << exercise.id << ": " << suite << " is no category";
      asked[category->id].insert(rows.begin(), rows.end());
    }
    for (const checks::Category& category : declared) {
      const std::string where = exercise.id + "/" + category.id;
      EXPECT_EQ(asked.contains(category.id), !category.functions.empty()) << where << ": public checks";
      EXPECT_LE(category.rows.size(), kMostRows) << where;
      std::set<std::string> known{"-", ""};
      for (const checks::Row& row : category.rows) known.insert(row.id);
      for (const std::string& row : asked[category.id])
        EXPECT_TRUE(known.contains(row)) << where << " has no row \"" << row << "\"";
      for (std::size_t i = 1; i < category.rows.size(); ++i)
        EXPECT_TRUE(asked[category.id].contains(category.rows[i].id))
            << where << ": no check points to the row \"" << category.rows[i].id << "\"";
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
