// STAFF ONLY. Tests that the sample class is packed as its groups say.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "grader/samples/sample.h"
#include "grader/samples/sample_builder.h"
#include "grader/samples/solution_files.h"
#include "hair/io/files/read_file.h"
#include "solver/test_refusal.h"

namespace grader::inline samples {
namespace {

namespace fs = std::filesystem;
using tests::says;

const fs::path kProject = HAIR_PROJECT, kClass = HAIR_SAMPLE_CLASS, kAttacks = HAIR_ATTACKS;

std::vector<Sample> all_samples() {
  return read_samples(kProject);
}

TEST(SampleClass, HoldsEverySampleAndNothingElse) {
  std::set<std::string> listed, packed;
  for (const Sample& sample : all_samples())
    if (sample.in_class()) listed.insert(sample.file_name());
  for (const auto& item : fs::directory_iterator(kClass)) packed.insert(item.path().filename().string());
  EXPECT_EQ(packed, listed);
  EXPECT_GE(listed.size(), 24u);
}

TEST(Showcase, HoldsWhatIsMarkedAndNothingElse) {
  const auto packed = [](const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& item : fs::directory_iterator(folder)) names.insert(item.path().filename().string());
    return names;
  };
  std::set<std::string> marked, first, groups, shown_groups;
  for (const Sample& sample : all_samples()) {
    if (sample.in_class()) groups.insert(sample.group);
    if (!sample.showcase) continue;
    shown_groups.insert(sample.group);
    marked.insert(sample.file_name());
    if (sample.first) first.insert(sample.file_name());
  }
  EXPECT_EQ(packed(HAIR_SHOWCASE), marked);
  EXPECT_EQ(packed(HAIR_FIRST_SAMPLES), first);
  EXPECT_EQ(shown_groups, groups) << "it saves the time of the class, and has a sample of each kind";
}

TEST(AttackCorpus, HoldsThePlacesAttacksAndWhatIsGradedBesideThem) {
  std::size_t attacks = 0;
  for (const std::string place : kPlaces) {
    SCOPED_TRACE(place);
    std::set<std::string> listed, packed;
    std::size_t honest = 0, here = 0;
    for (const Sample& sample : all_samples())
      if (sample.graded_at(place)) {
        listed.insert(sample.file_name());
        ++(sample.attack ? here : honest);
      }
    for (const auto& item : fs::directory_iterator(kAttacks / place))
      packed.insert(item.path().filename().string());
    EXPECT_EQ(packed, listed);
    EXPECT_GE(here, 7U);
    EXPECT_GE(honest, 2U);
    attacks += here;
  }
  EXPECT_GE(attacks, 60U);
}

// If its edits did nothing, a sample would be a right solution that is expected to be wrong.
TEST(SampleClass, EditsChangeAFile) {
  for (const Sample& sample : all_samples()) {
    if (sample.edits.empty()) continue;
    Sample unedited = sample;
    unedited.edits.clear();
    EXPECT_NE(solution_files(sample, kProject), solution_files(unedited, kProject)) << sample.name;
  }
}

// Both the points and the categories are written down: either shows an error in the other.
TEST(SampleClass, ShowcasesPointsAreThoseOfTheirCategories) {
  const SampleCategories categories =
      read_categories(kProject, read_course(kProject / "handout/exercises.json"));
  int compared = 0;
  for (const Sample& sample : all_samples())
    for (const auto& [id, expected] : sample.expected)
      if (sample.showcase && !expected.failed.empty()) {
        EXPECT_EQ(expected.points, points_without(categories.at(id), expected.failed))
            << sample.name << ", " << id;
        ++compared;
      }
  EXPECT_GE(compared, 14);
}

TEST(SampleTable, HasARowForEverySample) {
  const std::string table = table_of(all_samples());
  for (const Sample& sample : all_samples())
    EXPECT_TRUE(says(table, "| `" + sample.name + "` | " + sample.shows + " |")) << sample.name;
  for (const char* row :
       {"## Bugs in S1\n\n| sample | what it shows | gets |\n|---|---|---|\n",
        "| `perfect` | Every exercise, as the reference has it. | passed |\n",
        "| `h2-acos` | The angle is acos(u1 . u2). | H2 partly 28 |\n", "## Attacks: protocol\n\n| sample | ",
        "| `drips` | Sends a long message, a byte at a time, with a nap after each. | all waits together are "
        "limited | "
        "S1 timed out | S1 0 | 10 |\n"})
    EXPECT_TRUE(says(table, row));
}

// Counts a bug's own category, and at most two more.
constexpr int kMostCauses = 3;

TEST(BugSamples, LoseTheirCategoryAndAtMostTwoBesides) {
  std::map<std::string, std::vector<int>> causes;  // by exercise
  for (const Sample& sample : read_samples(fs::path(HAIR_PROJECT))) {
    if (sample.attack) continue;
    int most = 0;
    for (const auto& [id, expected] : sample.expected) {
      if (expected.failed.empty()) continue;
      const int lost = static_cast<int>(expected.failed.size());
      causes[id].push_back(lost);
      most = std::max(most, lost);
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

}  // namespace
}  // namespace grader::samples
