// STAFF ONLY. Tests that people who fail alike are found, by categories and by the size of errors.
#include "grader/report/facts/alike.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace grader::inline report {
namespace {

constexpr double kPasses = -1;

// Makes a person with one exercise, whose categories pass or have these errors over their limits.
SubmissionResult who_loses(const std::string& name, const std::vector<double>& errors) {
  ExerciseResult exercise;
  exercise.id = "S1";
  for (const double error : errors) {
    CaseResult one;
    if (error == kPasses)
      one.status = Status::passed;
    else
      one.error_in_limits = error;
    exercise.cases.push_back(one);
  }
  SubmissionResult result;
  result.name = name;
  result.exercises = {exercise};
  return result;
}

TEST(Alike, HasBandsOfErrors) {
  const std::vector<std::pair<double, ErrorSize>> rows = {
      {0, ErrorSize::unknown},           {1, ErrorSize::near},
      {9.99, ErrorSize::near},           {10, ErrorSize::up_to_a_thousand},
      {1e3, ErrorSize::up_to_a_million}, {1e6, ErrorSize::more},
      {kNoNumber, ErrorSize::not_finite}};
  for (const auto& [error, size] : rows)
    EXPECT_EQ(size_of(*lost_categories(who_loses("a", {error}).exercises[0])[0].one), size) << error;
}

// One lost category without a number, or all, are no sign; a group has at least three people.
TEST(Alike, NamesGroups) {
  const double lost = 0, near = 2, far = 2e7;
  std::vector<SubmissionResult> results;
  const auto add = [&](const std::vector<const char*>& names, const std::vector<double>& errors) {
    for (const char* name : names) results.push_back(who_loses(name, errors));
  };
  add({"a", "b", "c"}, {kPasses, lost, lost});
  add({"d", "e", "f"}, {kPasses, kPasses, lost});
  add({"g", "h", "i"}, {lost, lost, lost});
  add({"j", "k"}, {lost, kPasses, lost});
  add({"l", "m", "n", "o"}, {kPasses, kPasses, near});
  add({"p", "q"}, {kPasses, kPasses, far});
  add({"r", "s", "t"}, {near, far, kPasses});
  std::string found;
  for (const FailAlike& group : who_fail_alike(results)) {
    for (std::size_t i = 0; i < group.categories.size(); ++i)
      found += group.categories[i] + " (" + in_words(group.sizes[i]) + ") ";
    for (const std::string& name : group.people) found += name;
    found += "\n";
  }
  EXPECT_EQ(found,
            "S1.3 (up to 10 times the limit) lmno\n"
            "S1.1 (up to 10 times the limit) S1.2 (more than a million times the limit) rst\n"
            "S1.2 () S1.3 () abc\n");
}

}  // namespace
}  // namespace grader::report
