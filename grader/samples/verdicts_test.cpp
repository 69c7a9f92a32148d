// STAFF ONLY. Tests that a cause costs points once, in the samples' expected results.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "grader/samples/sample.h"

namespace grader::inline samples {
namespace {

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
