// STAFF ONLY. Tests on made-up people that each kind of item is found, keeps its key, and comes back when it
// changes.
#include "grader/review/items.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "grader/review/made_class.h"

namespace grader::inline review {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Exercises = std::vector<ExerciseResult>;

ItemFacts facts_of(const std::vector<SubmissionResult>& results) {
  ItemFacts facts;
  for (const SubmissionResult& result : results) facts.people[result.name] = {result};
  return facts;
}

// Writes a line for each item.
std::string keys(const std::vector<Item>& items) {
  std::string all;
  for (const Item& item : items)
    all += item.key() + (item.is_decided() ? " by " + item.decided_by : "") + "\n";
  return all;
}

TEST(Items, AreOfTheseKinds) {
  struct Row {
    const char* about;
    std::function<void(ItemPerson&)> change;
    std::string keys;
    const char* in_why = "";
  };
  const auto becomes = [](ExerciseResult exercise) {
    return [=](ItemPerson& person) { person.computed.exercises = {exercise}; };
  };
  const auto held = [&](int cases, int count) {
    ExerciseResult exercise = made_exercise("H2", {{3}});
    exercise.cases[2].cases = cases;
    exercise.cases[2].held = count;
    return becomes(exercise);
  };
  ExerciseResult breaks_off = with_picture(made_exercise("H4", {{8}}), 0, false);
  breaks_off.pictures.back().breaks_off = true;
  ExerciseResult two_files;
  two_files.id = "S2";
  two_files.status = Status::not_taken;
  two_files.feedback = "There are two versions of S2.cpp.";
  const ExerciseResult right = made_exercise("H2"),
                       all_lost = made_exercise("H6", {{1}, {2}, {3}, {4}, {5}, {6}, {7}, {8}});
  const auto points = [](double number, double computed, const char* place) {
    return [=](ItemPerson& person) {
      person.decisions = {
          {DecisionKind::points, place, number, computed, "why", "bob", "2025-01-01 10:00:00"}};
    };
  };
  const auto late = [](const char* time) { return [=](ItemPerson& person) { person.handed_in = time; }; };
  const std::vector<Row> rows = {
      {"all right", becomes(right), ""},
      {"an ordinary mistake", becomes(made_exercise("H2", {{3, 1e7}})), ""},
      {"no archive", [](ItemPerson& person) { person.computed.note = "This is no archive."; },
       "not-taken//ann\n", "This is no archive."},
      {"two files", becomes(two_files), "not-taken//ann\n", "S2: There are two versions of S2.cpp."},
      {"broke the rules", becomes(made_exercise("H2", {{1, 0, Status::broke_rules}, {2, 2}})),
       "broke-rules/H2/ann\n"},
      {"the clock",
       [](ItemPerson& person) {
         person.computed.ended_by_the_clock = {"H2", "S1"};
       },
       "not-final//ann\n", "H2, S1 ended by the clock"},
      {"a decision that holds", points(3, 16, "H2"), ""},
      {"a decision for other points", points(3, 5, "H2"), "conflict/H2/ann\n", "bob set H2 to 3"},
      {"a place and its category",
       [](ItemPerson& person) {
         for (const char* place : {"H2", "H2.3"})
           person.decisions.push_back(
               {DecisionKind::points, place, 2, place[2] == 0 ? 16.0 : 2.0, "why", "bob"});
       },
       "conflict/H2/ann\n", "both count"},
      {"a place that is gone", points(1, 1, "H2.9"), "conflict/H2.9/ann\n", "now there is no H2.9"},
      {"below 10 times the limit", becomes(made_exercise("H2", {{3, 6.6}, {5, 1e7}})),
       "near-threshold/H2/ann\n", "H2 is nearly right: H2.3 (Ill-conditioned): 6.6 times the limit"},
      {"10 times the limit", becomes(made_exercise("H2", {{3, 10.5}})), ""},
      {"all but one of the cases", held(12, 11), "near-threshold/H2/ann\n", "11 of 12 cases hold"},
      {"all but two", held(12, 10), ""},
      {"three of four", held(4, 3), ""},
      {"no number", becomes(made_exercise("H2", {{3, kInfinity}})), "blown-up/H2/ann\n", "no finite number"},
      {"a run that breaks off", becomes(breaks_off), "blown-up/H4/ann\n", "H4: its run breaks off"},
      {"a wrong picture of code that is right",
       becomes(with_picture(made_exercise("H6", {{8, 50}}), 0.2, false)), "far-in-pictures/H6/ann\n",
       "H6 reaches 14 of 16 points, and its picture at 0.50 s is off by FLIP 0.2"},
      {"a picture that is far off",
       becomes(with_picture(made_exercise("H6", {{1, 1e7}, {8, 50}}), 0.2, true)),
       "far-in-pictures/H6/ann\n"},
      {"nothing but a picture that is far off", becomes(with_picture(all_lost, 0.2, true)), ""},
      {"a picture near ours", becomes(with_picture(made_exercise("H6", {{1, 1e7}, {8, 50}}), 0.2, false)),
       ""},
      {"in time", late("2025-03-04 23:59:10"), ""},
      {"late by a minute", late("2025-03-05 00:00:00"), "near-threshold/late/ann\n",
       "Late by less than an hour"},
      {"late by an hour", late("2025-03-05 00:59:00"), "near-threshold/late/ann\n"},
      {"late by more", late("2025-03-05 01:00:00"), ""}};
  for (const Row& row : rows) {
    ItemFacts facts = facts_of({made_result("ann", {right})});
    facts.rules.due = "2025-03-04 23:59";
    row.change(facts.people["ann"]);
    const std::vector<Item> items = items_of(facts);
    EXPECT_EQ(keys(items), row.keys) << row.about;
    for (const Item& item : items) EXPECT_NE(item.why.find(row.in_why), std::string::npos) << item.why;
  }
}

TEST(Items, AreInOrderAndAPersonInAGroupIsNoOther) {
  std::vector<SubmissionResult> results;
  for (const char* name : {"a", "b", "c"})  // lose the same by about the same; "far" has another size
    results.push_back(made_result(name, {made_exercise("H2", {{3, 2}, {4, 5e7}})}));
  results.push_back(made_result("far", {made_exercise("H2", {{3, 2}, {4, 50}})}));
  for (const char* name : {"d", "e", "f", "g"})
    results.push_back(made_result(name, {made_exercise("H3", {{1, 2}})}));
  results.push_back(made_result("h", {made_exercise("H3", {{1, 3}, {2, 3}, {3, 1e5}})}));
  results.push_back(made_result("i", {made_exercise("H1", {{1, kInfinity}})}));
  results.push_back(made_result("j", {made_exercise("S1", {{1, 0, Status::broke_rules}})}));
  ItemFacts facts = facts_of(results);
  facts.requests = {{3, "a", "H2.3", "", "Why?", "", "", "", "", ""},
                    {4, "b", "", "", "Why?", "", "", "So.", "eve", "then"}};
  const std::string all =
      "broke-rules/S1/j\n"
      "request/H2.3/a\n"
      "near-threshold/H3.1 up to 10 times the limit/\n"
      "near-threshold/H3/h\n"
      "near-threshold/H2/far\n"
      "blown-up/H1/i\n"
      "alike/H2.3 up to 10 times the limit, H2.4 more than a million times the limit/\n"
      "request//b by eve\n";
  const std::vector<Item> items = items_of(facts);
  ASSERT_EQ(keys(items), all);
  const Item& group = items[6];
  EXPECT_EQ(group.people, (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_EQ(group.categories, (std::vector<std::string>{"H2.3", "H2.4"}));
  EXPECT_EQ(group.exercise, "H2");
  EXPECT_EQ(group.lost, 4);
}

// An accepted item stays so while it looks the same, whatever else changes; its version says if a decision
// about it was made since it was shown.
TEST(Items, ComeBackWhenTheyLookOtherwise) {
  ItemFacts facts = facts_of({made_result("ann", {made_exercise("H2", {{3, 2}}), made_exercise("S1")}),
                              made_result("ben", {made_exercise("H2")})});
  for (const char* name : {"cy", "di", "ed"})
    facts.people[name] = {made_result(name, {made_exercise("H3", {{1, 50}})})};
  const std::string single = "near-threshold/H2/ann", group = "alike/H3.1 10 to 1000 times the limit/";
  for (const Item& item : items_of(facts))
    facts.rows[item.row()] = {item.looks, "eve", "2025-01-01 10:00:00"};
  const auto find = [](const ItemFacts& now, const std::string& key) {
    for (const Item& item : items_of(now))
      if (item.key() == key) return item;
    return Item{};
  };
  struct Row {
    const char* about;
    std::function<void(ItemFacts&)> change;
    bool stays = true, same_version = true;
    std::string key;
  };
  const auto set = [](const char* name, const ExerciseResult& exercise) {
    return [=](ItemFacts& now) { now.people[name].computed.exercises[0] = exercise; };
  };
  const auto decide = [](const char* name, const char* place) {
    return [=](ItemFacts& now) { now.people[name].decisions = {{DecisionKind::points, place, 1, 1, "why"}}; };
  };
  const std::vector<Row> rows = {
      {"nothing", [](ItemFacts&) {}, true, true, single},
      {"an error about as large", set("ann", made_exercise("H2", {{3, 3}})), true, true, single},
      {"one category more", set("ann", made_exercise("H2", {{3, 2}, {4, 1e7}})), false, false, single},
      {"another crash", set("ann", made_exercise("H2", {{3, 2, Status::crashed}})), false, false, single},
      {"another exercise",
       [](ItemFacts& now) { now.people["ann"].computed.exercises[1] = made_exercise("S1", {{1}}); }, true,
       true, single},
      {"another person", set("ben", made_exercise("H2", {{3, 2}})), true, true, single},
      {"points for its category", decide("ann", "H2.3"), true, false, single},
      {"points for its exercise", decide("ann", "H2"), true, false, single},
      {"points elsewhere", decide("ann", "S1"), true, true, single},
      {"points of another", decide("ben", "H2.3"), true, true, single},
      {"one more person",
       [](ItemFacts& now) {
         now.people["flo"] = {made_result("flo", {made_exercise("H3", {{1, 60}})})};
       },
       false, false, group},
      {"another person in place of one",
       [](ItemFacts& now) {
         now.people.erase("ed");
         now.people["flo"] = {made_result("flo", {made_exercise("H3", {{1, 60}})})};
       },
       false, false, group},
      {"points of one of them", decide("di", "H3.1"), true, false, group}};
  for (const Row& row : rows) {
    ItemFacts now = facts;
    row.change(now);
    const Item before = find(facts, row.key), after = find(now, row.key);
    EXPECT_EQ(after.is_decided(), row.stays) << row.about;
    EXPECT_EQ(after.version == before.version, row.same_version) << row.about;
  }
}

TEST(Items, AreNewOnlyAfterAFirstLook) {
  ItemFacts facts =
      facts_of({made_result("ann", {made_exercise("S1")}), made_result("ben", {made_exercise("S1")})});
  EXPECT_EQ(keys(items_of(facts)), "") << "nobody has looked";
  for (const auto& [row, looks] : first_look(facts)) facts.rows[row].looks = looks;
  EXPECT_EQ(keys(items_of(facts)), "") << "all are known";
  EXPECT_TRUE(first_look(facts).empty());
  facts.people["ann"].computed.exercises = {made_exercise("S1", {{1, 1e7}})};
  facts.people["cy"] = {made_result("cy", {made_exercise("S1")})};
  const std::vector<Item> items = items_of(facts);
  ASSERT_EQ(keys(items), "changed//ann\nchanged//cy\n");
  EXPECT_EQ(items[0].why, "The result is another one than before: 14 of 16 points");
  EXPECT_EQ(items[1].why, "The hand-in is new: 16 of 16 points");
  facts.rows[items[1].row()].open_by = "eve";
  EXPECT_EQ(items_of(facts)[1].why, items[1].why) << "eve has it open, and no more";
  facts.rows[items[1].row()] = {items[1].looks, "eve", "2025-01-01 10:00:00"};
  EXPECT_EQ(keys(items_of(facts)), "changed//ann\nchanged//cy by eve\n");
}

}  // namespace
}  // namespace grader::review
