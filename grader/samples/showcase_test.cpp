// STAFF ONLY. Tests that the showcase, which saves the time of the whole class, has every kind of sample.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "grader/samples/sample.h"

namespace grader::inline samples {
namespace {

namespace fs = std::filesystem;

std::vector<Sample> shown() {
  std::vector<Sample> samples = read_samples(HAIR_PROJECT);
  std::erase_if(samples, [](const Sample& sample) { return !sample.showcase; });
  return samples;
}

std::vector<std::string> names_where(const std::function<bool(const Sample&)>& holds) {
  std::vector<std::string> names;
  for (const Sample& sample : shown())
    if (holds(sample)) names.push_back(sample.name);
  return names;
}

std::set<std::string> statuses(const std::vector<Sample>& samples) {
  std::set<std::string> all;
  for (const Sample& sample : samples)
    for (const auto& [exercise, expected] : sample.expected) all.insert(expected.status);
  return all;
}

std::set<std::string> groups(const std::vector<Sample>& samples) {
  std::set<std::string> all;
  for (const Sample& sample : samples) all.insert(sample.group);
  return all;
}

TEST(Showcase, IsGradedSoon) {
  // These are a bug in every exercise, and the other kinds.
  const std::vector<Sample> samples = shown();
  ASSERT_FALSE(samples.empty());
  EXPECT_LE(samples.size(), samples.front().expected.size() + 16);
}

// Each group of the class is a kind: the bugs in an exercise, attacks on the grade, archives, ...
TEST(Showcase, HasASampleOfEveryGroup) {
  std::vector<Sample> of_the_class = read_samples(HAIR_PROJECT);
  std::erase_if(of_the_class, [](const Sample& sample) { return !sample.in_class(); });
  EXPECT_EQ(groups(shown()), groups(of_the_class));
}

TEST(Showcase, HasEveryStatus) {
  EXPECT_EQ(statuses(shown()), statuses(read_samples(HAIR_PROJECT)));
}

TEST(Showcase, HasThreeThatAreRight) {
  const std::vector<std::string> right = names_where([](const Sample& sample) {
    return sample.group == "right" && std::ranges::all_of(sample.expected, [](const auto& of) {
             return of.second.status == "passed" || of.second.status == "missing";
           });
  });
  EXPECT_GE(right.size(), 3U);
  EXPECT_EQ(std::ranges::count(right, "perfect"), 1);
}

TEST(Showcase, HasAnHonestBugInEveryExercise) {
  const std::vector<Sample> samples = shown();
  ASSERT_FALSE(samples.empty());
  for (const auto& [exercise, expected] : samples.front().expected) {
    const std::vector<std::string> bugs = names_where([&id = exercise](const Sample& sample) {
      return sample.group == id && sample.expected.at(id).status != "passed";
    });
    EXPECT_FALSE(bugs.empty()) << exercise;
  }
}

TEST(Showcase, HasThreeAttacks) {
  const auto attacks = [](const Sample& sample) { return sample.group.starts_with("attacks-on-"); };
  EXPECT_GE(names_where(attacks).size(), 3U);
}

TEST(Showcase, HoldsWhatIsMarkedAndNothingElse) {
  const auto packed = [](const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& item : fs::directory_iterator(folder)) names.insert(item.path().filename().string());
    return names;
  };
  std::set<std::string> marked, first;
  for (const Sample& sample : shown()) {
    marked.insert(sample.file_name());
    if (sample.first) first.insert(sample.file_name());
  }
  EXPECT_EQ(packed(HAIR_SHOWCASE), marked);
  EXPECT_EQ(packed(HAIR_FIRST_SAMPLES), first);
}

// The exercise that is not right decides the kind.
TEST(FirstSamples, AreTwelveKinds) {
  std::map<std::string, std::set<std::string>> kinds;
  for (const Sample& sample : shown()) {
    if (!sample.first) continue;
    std::string kind;
    for (const auto& [id, expected] : sample.expected)
      if (expected.status != "passed" && expected.status != "missing") kind = expected.status;
    if (kind == "partly" && sample.group == "whole-runs") kind = "whole run";
    if (kind.empty()) kind = sample.name == "perfect" ? "the reference solution" : "right by another way";
    kinds[kind].insert(sample.name);
  }
  EXPECT_EQ(kinds.size(), 12U);
  for (const auto& [kind, names] : kinds) EXPECT_EQ(names.size(), 1U) << kind;
  for (const char* kind : {"the reference solution", "right by another way", "partly", "wrong",
                           "not implemented", "does not compile", "crashed", "timed out", "out of memory",
                           "broke the rules", "can't be read", "whole run"})
    EXPECT_TRUE(kinds.contains(kind)) << kind;
}

}  // namespace
}  // namespace grader::samples
