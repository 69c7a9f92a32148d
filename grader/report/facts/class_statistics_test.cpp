// STAFF ONLY. Tests statistics on classes with known numbers, and that people who fail alike are found, by
// categories and by the size of errors.
#include "grader/report/facts/class_statistics.h"

#include <gtest/gtest.h>

#include <numeric>
#include <utility>
#include <vector>

#include "grader/report/facts/alike.h"
#include "grader/report/pages/pages.h"
#include "solver/test_refusal.h"

namespace grader::inline report {
namespace {

using tests::says;

// Makes one exercise of two points; each category that `passes` gives one.
SubmissionResult person(const std::string& name, std::vector<bool> passes) {
  ExerciseResult exercise{
      .id = "S1", .status = Status::partly, .max_points = static_cast<double>(passes.size())};
  for (const bool passed : passes) {
    const double points = passed ? 1 : 0;
    exercise.points += points;
    exercise.cases.push_back({"A category", passed ? Status::passed : Status::wrong, points, 1});
  }
  return {.name = name, .exercises = {exercise}};
}

// 0.27 * 11 = 2.97: three of eleven people are strong, and three are weak.
TEST(ClassStatistics, CategoriesTellStrongFromWeakPeople) {
  std::vector<SubmissionResult> results;
  for (int i = 0; i < 11; ++i) {
    const bool strong = i < 3, weak = i >= 8;
    // Strong people alone pass the first category, all people the second, weak ones alone the third. Weak
    // people fail three more, which makes the others strong.
    results.push_back(person("p" + std::to_string(i), {strong, true, weak, !weak, !weak, !weak}));
  }
  for (const CategoryStatistics& category : category_statistics(results)) {
    ASSERT_TRUE(category.discrimination) << category.number;
    const double expected = category.number == "S1.2" ? 0 : category.number == "S1.3" ? -1 : 1;
    EXPECT_EQ(*category.discrimination, expected) << category.number;
  }
  EXPECT_EQ(category_statistics(results).front().passed, 3U) << "the hardest first";
  results.resize(9);
  EXPECT_FALSE(category_statistics(results).front().discrimination);
}

TEST(ClassStatistics, EachPersonCountsOnce) {
  const std::vector<SubmissionResult> results{
      person("a", {false, false, false}), person("b", {true, false, false}), person("c", {true, true, true})};
  const std::vector<ExerciseStatistics> exercises = exercise_statistics(results);
  ASSERT_EQ(exercises.size(), 1U);
  EXPECT_EQ(exercises[0].tenths, (Tenths{1, 0, 0, 1, 0, 0, 0, 0, 0, 1}));
  EXPECT_EQ(exercises[0].tenths, tenths_of_totals(results));
  EXPECT_EQ(std::accumulate(exercises[0].points.begin(), exercises[0].points.end(), 0.0), 4);
}

TEST(ClassStatistics, QuartilesLieBetweenPeopleInProportion) {
  EXPECT_EQ(quantile({}, 0.5), 0);
  EXPECT_EQ(quantile({7}, 0.25), 7);
  EXPECT_EQ(quantile({4, 0, 2}, 0.5), 2);
  EXPECT_EQ(quantile({4, 0, 2}, 0.25), 1);
  EXPECT_EQ(quantile({0, 2, 4, 6}, 0.75), 4.5);
  EXPECT_EQ(quantile({0, 2, 4, 6}, 1), 6);
}

TEST(ClassStatistics, SectionsCountEachOfTheirPeopleOnce) {
  std::vector<SubmissionResult> results;
  for (int i = 0; i < 5; ++i) {
    std::vector<bool> passes(4, false);
    std::fill_n(passes.begin(), i, true);
    results.push_back(person("p" + std::to_string(i), passes));
  }
  const std::vector<ClassLine> people{
      {"p0", "Ann", "1", "", "Tutorial 10", ""},       {"p2", "Bo", "2", "", "Tutorial 10", ""},
      {"p3", "Cy", "3", "", "Tutorial 2", ""},         {"p1", "Cy", "3", "", "Tutorial 2", ""},
      {"p3", "Di", "4", "", "Tutorial 2", ""},         {"", "Ed", "5", "", "Tutorial 2", "nothing handed in"},
      {"", "Flo", "6", "", "<b>", "nothing handed in"}};
  const std::vector<SectionStatistics> sections = section_statistics(results, people);
  ASSERT_EQ(sections.size(), 3U);
  EXPECT_EQ(sections[1].name, "Tutorial 2") << "numbers count as such";
  EXPECT_EQ(sections[1].people, 3U);
  EXPECT_EQ(sections[1].handed_in, 2U) << "two hand-ins of one person; of a group's each member has one";
  EXPECT_EQ(sections[1].median, 3) << "the better one";
  EXPECT_EQ(sections[2].name, "Tutorial 10");
  EXPECT_EQ(sections[2].first_quartile, 0.5);
  EXPECT_EQ(sections[2].third_quartile, 1.5);
  const std::string page = class_page(results, {.people = people});
  EXPECT_TRUE(
      says(page,
           "<tr><th scope=\"row\">&lt;b&gt;</th><td class=\"number\">1</td><td class=\"number\">0</td><td "
           "class=\"number\"></td>"));
  EXPECT_TRUE(section_statistics(results, {{"p0", "Ann", "1", "", "", ""}}).empty());
  EXPECT_FALSE(says(class_page(results, {}), "id=\"sections\""));
}

// A broken archive is one person, who is in no list of exercises.
TEST(ClassStatistics, ThePageCountsPeopleAndNotCells) {
  SubmissionResult broken = person("broken", {});
  broken.note = "This is no archive.";
  broken.exercises.assign(14, {.id = "S1", .status = Status::unreadable});
  const std::string page = class_page({broken, person("b", {true, false})});
  EXPECT_TRUE(says(page, "could not be taken</span> 1"));
  const std::string status = badge(Status::unreadable).text + " 1";
  EXPECT_FALSE(says(page, status));
  broken.note.clear();
  EXPECT_TRUE(says(class_page({broken}), status + "</summary>")) << "one person, with 14 exercises";
}

constexpr double kPasses = -1;

// Makes a person with one exercise, whose categories pass or have these errors over their limits.
SubmissionResult who_loses(const std::string& name, const std::vector<double>& errors) {
  ExerciseResult exercise{.id = "S1"};
  for (const double error : errors)
    exercise.cases.push_back(error == kPasses ? CaseResult{.status = Status::passed}
                                              : CaseResult{.error_in_limits = error});
  return {.name = name, .exercises = {exercise}};
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
