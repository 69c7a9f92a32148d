// STAFF ONLY. Tests that people who fail alike are found, by categories and by the size of errors.
#include "grader/report/facts/alike.h"

#include <gtest/gtest.h>

#include <limits>

namespace grader::inline report {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Makes a person with one exercise: "" is a category that passes, any other text is a lost one's detail.
SubmissionResult who_loses(const std::string& name, const std::vector<std::string>& details) {
  ExerciseResult exercise;
  exercise.id = "S1";
  for (const std::string& detail : details)
    exercise.cases.push_back(
        {"A category", detail.empty() ? Status::passed : Status::wrong, 0, 1, "", detail});
  SubmissionResult result;
  result.name = name;
  result.exercises = {exercise};
  return result;
}

// trial_test.cpp expects the first text of the judge.
TEST(Alike, ReadsTheSizeOfErrorsFromTheirTextForStaff) {
  struct Row {
    const char* detail;
    std::optional<double> times;
    ErrorSize size;
  };
  const std::vector<Row> rows = {
      {"a hidden case: the error of x: 0.0625, bound 0.03125; more for staff", 2, ErrorSize::near},
      {"the error of x: 3e-09, bound 1e-09", 3, ErrorSize::near},
      {"n = 3: the error: 5e-10, bound 1e-12; f(x: 2, bound 1)", 500, ErrorSize::up_to_a_thousand},
      {"e: 1e3, bound 1", 1e3, ErrorSize::up_to_a_million},
      {"e: 1e6, bound 1", 1e6, ErrorSize::more},
      {"e: nan, bound 1", kInfinity, ErrorSize::not_finite},
      {"e: -nan, bound 1", kInfinity, ErrorSize::not_finite},
      {"e: inf, bound 1", kInfinity, ErrorSize::not_finite},
      {"e: 1, bound nan", kInfinity, ErrorSize::not_finite},
      {"", {}, ErrorSize::unknown},
      {", bound 1", {}, ErrorSize::unknown},
      {"it says 2, bound 1", {}, ErrorSize::unknown},
      {"the code threw an exception", {}, ErrorSize::unknown}};
  for (const Row& row : rows) {
    CaseResult one;
    one.detail = row.detail;
    const std::optional<double> times = times_the_limit(one);
    ASSERT_EQ(times.has_value(), row.times.has_value()) << row.detail;
    EXPECT_DOUBLE_EQ(times.value_or(0), row.times.value_or(0)) << row.detail;
    EXPECT_EQ(size_of(times), row.size) << row.detail;
  }
}

// One lost category without a number, or all, are no sign; a group has at least three people.
TEST(Alike, NamesGroups) {
  const std::string lost = "stopped", near = "e: 2, bound 1", far = "e: 2e7, bound 1";
  std::vector<SubmissionResult> results;
  const auto add = [&](const std::vector<const char*>& names, const std::vector<std::string>& details) {
    for (const char* name : names) results.push_back(who_loses(name, details));
  };
  add({"a", "b", "c"}, {"", lost, lost});
  add({"d", "e", "f"}, {"", "", lost});
  add({"g", "h", "i"}, {lost, lost, lost});
  add({"j", "k"}, {lost, "", lost});
  add({"l", "m", "n", "o"}, {"", "", near});
  add({"p", "q"}, {"", "", far});
  add({"r", "s", "t"}, {near, far, ""});
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
