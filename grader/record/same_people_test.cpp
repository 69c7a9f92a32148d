// STAFF ONLY. Tests that groups that change keep their seed, and that no two share one.
#include "grader/record/same_people.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace grader::inline record {
namespace {

HandIn group(const std::string& name, const std::string& id, const std::vector<std::string>& members) {
  HandIn one{name, {.name = name, .id = id, .group = true}, "gradescope"};
  for (const std::string& member : members) one.owner.members.push_back({.name = "M" + member, .id = member});
  return one;
}

std::vector<Drawn> at_first(const std::vector<HandIn>& hand_ins) {
  const std::vector<std::string> from = drawn_from({}, hand_ins);
  std::vector<Drawn> all;
  for (std::size_t i = 0; i < hand_ins.size(); ++i) all.push_back({hand_ins[i], from[i]});
  return all;
}

TEST(DrawnFrom, TheNameAtFirstSight) {
  const HandIn doe{"doe_1", {.name = "Doe", .id = "1"}, "canvas"};
  EXPECT_EQ(drawn_from({}, {doe}), std::vector<std::string>{"doe_1"});
  // The number has another name, as after a marriage; the same number in another system is another person's.
  EXPECT_EQ(drawn_from({{doe, "x"}}, {{"roe_1", {.name = "Roe", .id = "1"}, "canvas"}}),
            std::vector<std::string>{"x"});
  EXPECT_EQ(drawn_from({{doe, "x"}}, {{"roe_1", {.name = "Roe", .id = "1"}, "moodle"}}),
            std::vector<std::string>{"roe_1"});
}

TEST(DrawnFrom, OfAGroupItsIdDecidesWhereItHasOne) {
  const std::vector<Drawn> before = at_first({group("a", "7", {"1", "2"}), group("b", "8", {"3", "4"})});
  // Names and members are exchanged, ids stay.
  EXPECT_EQ(drawn_from(before, {group("b", "7", {"3", "4"}), group("a", "8", {"1", "2"})}),
            (std::vector<std::string>{"a", "b"}));
  // Moodle does not list a team's members.
  const std::vector<Drawn> teams = at_first({group("a", "7", {}), group("b", "8", {})});
  EXPECT_EQ(drawn_from(teams, {group("c", "8", {}), group("b", "9", {})})[0], "b");
  EXPECT_NE(drawn_from(teams, {group("c", "8", {}), group("b", "9", {})})[1], "b");
}

TEST(DrawnFrom, ANameThatAnotherGroupTakesIsNotItsId) {
  const std::vector<Drawn> before = at_first({group("a", "", {"1", "2"})});
  const std::vector<HandIn> now{group("a", "", {"3", "4"}), group("b", "", {"1", "2"})};
  const std::vector<std::string> from = drawn_from(before, now);
  EXPECT_EQ(from[1], "a");
  EXPECT_NE(from[0], "a");
  EXPECT_EQ(drawn_from(before, {now[0]})[0], from[0]);  // also if the first group hands in nothing any more
}

TEST(DrawnFrom, WhoIsLeftAloneKeepsTheGroups) {
  const std::vector<Drawn> before = at_first({group("a", "", {"1", "2"})});
  const HandIn alone{"M1_1", {.name = "M1", .id = "1"}, "gradescope"};
  EXPECT_EQ(drawn_from(before, {alone})[0], "a");
}

std::string names_of(const std::vector<RowName>& rows) {
  std::string names;
  for (const RowName& row : rows) names += (names.empty() ? "" : " ") + row.name;
  return names;
}

TEST(RowNames, StayForTheSamePeople) {
  const std::vector<Drawn> before = at_first({group("a", "", {"1", "2"}),
                                              group("b", "", {"3", "4", "5"}),
                                              {"doe_1", {.name = "Doe", .id = "9"}, "canvas"},
                                              {"jane doe", {.name = "jane doe"}, "folders"}});
  const auto rows = [&](const std::vector<HandIn>& now) { return row_names(before, now); };
  // The group has a new name, and a new member.
  const std::vector<RowName> renamed =
      rows({group("c", "", {"1", "2", "6"}), group("b", "", {"3", "4", "5"})});
  EXPECT_EQ(names_of(renamed), "a b");
  EXPECT_EQ(renamed[0].told, "c: is a under another name, and keeps its row");
  EXPECT_EQ(renamed[1].told, "");
  // Two groups exchange their names.
  EXPECT_EQ(names_of(rows({group("b", "", {"1", "2"}), group("a", "", {"3", "4", "5"})})), "a b");
  EXPECT_EQ(names_of(rows({{"roe_1", {.name = "Roe", .id = "9"}, "canvas"}})), "doe_1");
  HandIn with_others = group("team_9", "9", {"9", "10"});
  with_others.system = "canvas";
  EXPECT_EQ(names_of(rows({with_others})), "team_9") << "others have not what one was graded for";
  EXPECT_EQ(names_of(rows({{"Jane_Doe", {.name = "Jane Doe"}, "folders"}})), "Jane_Doe")
      << "a name alone is no evidence";
  // The name is the same, and a member has left: it is still the group of that name.
  EXPECT_EQ(names_of(rows({group("b", "", {"3", "4"})})), "b");
}

TEST(RowNames, AreNewWhereSomebodyHasLeftOrOthersHaveTheName) {
  const std::vector<Drawn> before = at_first({group("a", "", {"1", "2", "3"})});
  const std::vector<RowName> left = row_names(before, {group("c", "", {"1", "2"})});
  EXPECT_EQ(names_of(left), "c");
  EXPECT_EQ(left[0].told,
            "c: is a, but somebody has left it, and has a row of its own; decisions about a stay there");
  EXPECT_EQ(names_of(row_names(before, {{"M1_1", {.name = "M1", .id = "1"}, "gradescope"}})), "M1_1")
      << "one alone has not what others were graded for";
  // Other people have the name a now: they must not get decisions about the first group.
  const HandIn others = group("a", "", {"7", "8"});
  const std::vector<RowName> taken = row_names(before, {others, group("b", "", {"1", "2", "3"})});
  EXPECT_EQ(taken[1].name, "a");
  ASSERT_NE(taken[0].name, "a");
  EXPECT_TRUE(taken[0].name.starts_with("a-")) << taken[0].name;
  EXPECT_NE(taken[0].told, "");
  // The name stays in the next download.
  std::vector<Drawn> then = before;
  then.push_back({others, "x"});
  then.back().hand_in.name = taken[0].name;
  EXPECT_EQ(names_of(row_names(then, {others})), taken[0].name);
}

TEST(RowNames, OfCanvasGroupsDontFollowWhoeverHandedIn) {
  HandIn was = group("team7_1", "1", {"1", "2"}), now = group("rockets_1", "1", {"1", "3"});
  was.system = now.system = "canvas";
  EXPECT_EQ(names_of(row_names(at_first({was}), {now})), "rockets_1");
  now = group("rockets_2", "2", {"1", "2"});
  now.system = "canvas";
  EXPECT_EQ(names_of(row_names(at_first({was}), {now})), "team7_1");
}

}  // namespace
}  // namespace grader::record
