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

std::size_t count_where(const std::function<bool(const Sample&)>& holds) {
  return static_cast<std::size_t>(std::ranges::count_if(shown(), holds));
}

std::set<std::string> statuses(const std::vector<Sample>& samples) {
  std::set<std::string> all;
  for (const Sample& sample : samples)
    for (const auto& [exercise, expected] : sample.expected) all.insert(expected.status);
  return all;
}

// Each group of the class is a kind: the bugs in an exercise, attacks on the grade, archives, ...
std::set<std::string> groups(const std::vector<Sample>& samples) {
  std::set<std::string> all;
  for (const Sample& sample : samples)
    if (sample.in_class()) all.insert(sample.group);
  return all;
}

TEST(Showcase, HasEveryKindAndIsGradedSoon) {
  const std::vector<Sample> samples = shown(), all = read_samples(HAIR_PROJECT);
  ASSERT_FALSE(samples.empty());
  // These are a bug in every exercise, and the other kinds.
  EXPECT_LE(samples.size(), samples.front().expected.size() + 16);
  EXPECT_EQ(groups(samples), groups(all));
  EXPECT_EQ(statuses(samples), statuses(all));
  const auto is_right = [](const Sample& sample) {
    return sample.group == "right" && std::ranges::all_of(sample.expected, [](const auto& of) {
             return of.second.status == "passed" || of.second.status == "missing";
           });
  };
  EXPECT_GE(count_where(is_right), 3U);
  EXPECT_EQ(count_where([&](const Sample& sample) { return is_right(sample) && sample.name == "perfect"; }),
            1U);
  EXPECT_GE(count_where([](const Sample& sample) { return sample.group.starts_with("attacks-on-"); }), 3U);
  for (const auto& [exercise, expected] : samples.front().expected)
    EXPECT_GT(count_where([&id = exercise](const Sample& sample) {
                return sample.group == id && sample.expected.at(id).status != "passed";
              }),
              0U)
        << exercise << " has no honest bug";
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
