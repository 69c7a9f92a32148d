// STAFF ONLY. A cause costs points once, and each promise of a header is asked for: as the samples say, and the class is graded to.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include "grader/course/input.h"
#include "grader/samples/promises.h"
#include "grader/samples/sample.h"
#include "grader/samples/small_project.h"

namespace grader {
namespace {

// A bug's own category, and at most two besides; the whole run with its pictures is one.
constexpr int kMostCauses = 3;

TEST(BugSamples, LoseTheirCategoryAndAtMostTwoBesides) {
  std::map<std::string, std::vector<int>> causes;  // by exercise
  for (const Sample& sample : read_samples(fs::path(HAIR_PROJECT))) {
    if (sample.attack) continue;
    int most = 0;
    for (const auto& [id, expected] : sample.expected) {
      if (expected.failed.empty()) continue;
      causes[id].push_back(expected.causes);
      most = std::max(most, expected.causes);
    }
    if (most == 0) continue;
    if (sample.useless.empty())
      EXPECT_LE(most, kMostCauses) << sample.name << " loses too many categories for one mistake";
    else
      EXPECT_GT(most, kMostCauses) << sample.name << " needs no line \"useless\"";
  }
  for (auto& [id, numbers] : causes) {
    std::ranges::nth_element(numbers, numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2));
    EXPECT_LE(numbers[numbers.size() / 2], 2) << id << ": the median";
  }
}

TEST(Headers, PromiseNothingThatNoProgramLosesPointsFor) {
  const std::vector<Sample> samples = read_samples(fs::path(HAIR_PROJECT));
  for (const Promises& of : promises_of(fs::path(HAIR_PROJECT), samples)) {
    for (const Promise& promise : of.sentences) {
      EXPECT_TRUE(promise.explained || !promise.broken_by.empty())
          << of.header << ": no sample of " << of.exercise << " breaks, and nothing explains: \""
          << promise.sentence << "\"";
      for (const Sample* sample : promise.broken_by)
        EXPECT_NE(sample->expected.at(of.exercise).status, "passed") << sample->name;
    }
  }
}

// PROMISES.md has more columns behind these: a grading fills them.
TEST(PromisesTable, IsOfTheseHeadersAndSamples) {
  const fs::path project = HAIR_PROJECT;
  const std::vector<Sample> samples = read_samples(project);
  std::istringstream expected(table_of(promises_of(project, samples)));
  std::ifstream table(project / "grader/samples/PROMISES.md");
  for (std::string line, written; std::getline(expected, line);)
    ASSERT_TRUE(std::getline(table, written) && written.starts_with(line))
        << "make PROMISES.md again, as it says, for it should have: " << line << "\nand has: " << written;
  std::string more;
  EXPECT_FALSE(std::getline(table, more)) << more;
}

TEST(SentencesOf, AreThoseOfTheComments) {
  EXPECT_EQ(sentences_of("// A. Nother: x is 0. y,\n// too (1.5).\n//\n//   f = k\n#pragma once\n\n"
                         "// E, in J.\ndouble e(int n);  // n >= 0\n}  // namespace a\n"),
            (std::vector<std::string>{"A. Nother: x is 0.", "y, too (1.5).", "f = k", "E, in J.", "n >= 0"}));
}

fs::path project_that_promises(const std::string& lines) {
  const fs::path project = small_project("one\n");
  std::ofstream(project / "a.h") << "// x is an\n// output. y stays. A unit is 1 |m|.\n";
  std::ofstream(project / "b.h") << "// z.\n";
  add_sample(project, "more", "form zip\nfile plain a.cpp\nfails A Two\n" + lines);
  return project;
}

std::vector<Sample> samples_of(const fs::path& project) {
  return read_samples(project, project / "categories.json");
}

TEST(PromisesOf, AreBrokenOrExplained) {
  const fs::path project = project_that_promises("breaks output. y stays\n");
  const std::vector<Sample> samples = samples_of(project);
  const std::vector<Promises> all = promises_of(project, samples);
  ASSERT_EQ(all.size(), 2U);
  ASSERT_EQ(all[0].sentences.size(), 3U);
  EXPECT_EQ(all[0].sentences[0].broken_by.size(), 1U);
  EXPECT_EQ(all[0].sentences[1].broken_by.size(), 1U);
  EXPECT_TRUE(all[0].sentences[2].broken_by.empty());
  EXPECT_TRUE(all[1].sentences[0].broken_by.empty());
  const std::string table = table_of(all);
  EXPECT_NE(table.find("| x is an output. | `more`: It. | The second |"), std::string::npos) << table;
  EXPECT_NE(table.find("| A unit is 1 \\|m\\|. | | |"), std::string::npos) << table;
  const auto failed = [](const Sample&, const std::string&) { return FailedCase{"x = 1", "it is wrong"}; };
  EXPECT_NE(table_of(all, failed).find("| The second | x = 1 | it is wrong |\n"), std::string::npos);
}

TEST(PromisesOf, RefusesWordsThatStandNowhere) {
  const fs::path project = project_that_promises("breaks z.\n");
  const std::vector<Sample> samples = samples_of(project);
  EXPECT_THROW(promises_of(project, samples), BadInput) << "of an exercise that the sample does not break";
}

}  // namespace
}  // namespace grader
