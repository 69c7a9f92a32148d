// STAFF ONLY. Every category of a text's table has public checks, and every check belongs to a category: so each loss can be foreseen. The
// definition HAIR_CHECKS names the folder of the programs reference_ID_check.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>
#include <sstream>

#include "grader/course/course.h"
#include "handout/checks/text_tables.h"

namespace grader {
namespace {

namespace fs = std::filesystem;

// Asked of all of the other categories' code at once.
const std::set<std::string> kInGradingAlone = {"The whole run", "Pictures of it", "No memory errors"};

struct Listed {
  std::string check, category, seen;
};

std::vector<Listed> checks_of(const std::string& exercise) {
  const std::string command = std::string(HAIR_CHECKS) + "/reference_" + exercise + "_check --list";
  const std::unique_ptr<FILE, int (*)(FILE*)> program(popen(command.c_str(), "r"), pclose);
  std::string output;
  std::array<char, 4096> block{};
  while (std::size_t got = fread(block.data(), 1, block.size(), program.get()))
    output.append(block.data(), got);
  std::vector<Listed> all;
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    Listed one;
    std::istringstream cells(line);
    std::getline(cells, one.check, '\t');
    std::getline(cells, one.category, '\t');
    std::getline(cells, one.seen, '\t');
    all.push_back(one);
  }
  return all;
}

TEST(PublicChecks, ForeseeEachCategory) {
  const fs::path handout = fs::path(HAIR_PROJECT) / "handout";
  for (const Exercise& exercise : read_course(handout / "exercises.json").exercises) {
    const std::vector<Listed> checks = checks_of(exercise.id);
    ASSERT_GE(checks.size(), 5U) << exercise.id;
    const checks::TextTables text = checks::read_text_tables((handout / exercise.text).string());
    std::set<std::string> titles, asked;
    for (const auto& category : text.categories) titles.insert(category.title);
    for (const Listed& one : checks) {
      const auto begins = [&](const checks::TextTables::Row& row) { return row.seen.starts_with(one.seen); };
      EXPECT_EQ(one.seen.empty() ? 1 : std::ranges::count_if(text.symptoms, begins), 1)
          << one.check << " points to \"" << one.seen << "\": " << exercise.text
          << " has no such row, or several";
      EXPECT_TRUE(titles.contains(one.category))
          << one.check << " belongs to \"" << one.category << "\", which the table of " << exercise.text
          << " does not have";
      asked.insert(one.category);
    }
    for (const std::string& title : titles)
      EXPECT_TRUE(asked.contains(title) || kInGradingAlone.contains(title))
          << exercise.id << ": no public check foresees \"" << title << "\"";
  }
}

}  // namespace
}  // namespace grader
