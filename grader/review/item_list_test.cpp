// STAFF ONLY. Tests the list of a record's items: what TAs do with them, one after another and at once.
#include "grader/review/item_list.h"

#include <gtest/gtest.h>

#include <iostream>

#include "grader/course/input.h"
#include "grader/record/schema.h"
#include "grader/review/made_class.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_refusal.h"
#include "solver/timing.h"

namespace grader::inline review {
namespace {

const std::string kNear = "near-threshold/H2/ann", kGroup = "alike/H3.1 10 to 1000 times the limit/";

std::string version_of(ItemList& list, const std::string& key) {
  return list.find(key).value().version;
}

void save(ItemList& list, const std::string& key, const ItemList::Change& change = {}) {
  list.save(key, version_of(list, key), change);
}

// Ann has an item of her own, and three have one in common.
class Lists : public testing::Test {
 protected:
  Lists() {
    record_.put({made_result("ann", {made_exercise("H2", {{3, 2}}), made_exercise("S1")})});
    for (const char* name : {"cy", "di", "ed"})
      record_.put({made_result(name, {made_exercise("H3", {{1, 50}})})});
  }
  static ItemList::Change points(const char* place, double number) {
    return [=](Record& record, const std::string& name) {
      record.decide(name, {DecisionKind::points, place, number, 0, "why"});
    };
  }
  static std::string refusal(const std::function<void()>& call) {
    return tests::refusal<ChangedMeanwhile>(call);
  }
  std::string decisions() {
    std::string all;
    for (const std::string& name : record_.names())
      for (const Decision& one : record_.decisions(name))
        all += name + " " + decision_text(one) + " (" + one.who + ")\n";
    return all;
  }

  hair::TemporaryFolder temporary_{"item-list"};
  Record record_{temporary_.path()}, other_{temporary_.path()};
  std::int64_t now_ = 1'000'000;
  ItemList ada_{record_, "ada", [this] { return now_; }}, bob_{other_, "bob", [this] { return now_; }};
};

TEST_F(Lists, DecideForAllOrForNobody) {
  EXPECT_THROW(save(ada_, kGroup,
                    [&](Record& record, const std::string& name) {
                      points("H3.1", name == "ed" ? 99 : 1)(record, name);
                    }),
               BadInput);
  EXPECT_EQ(decisions(), "");
  EXPECT_FALSE(bob_.find(kGroup)->is_decided());
  save(ada_, kGroup, points("H3.1", 1));
  EXPECT_EQ(decisions(),
            "cy points H3.1: 1 (computed: 0): why (ada)\ndi points H3.1: 1 (computed: 0): why (ada)\n"
            "ed points H3.1: 1 (computed: 0): why (ada)\n");
  EXPECT_EQ(bob_.find(kGroup)->decided_by, "ada");
  const LogEntry last = record_.log("ed").back();
  EXPECT_EQ(last.who + " " + last.did + " " + last.detail.substr(0, 10), "ada accepted fail alike");
}

// Two save at once: one of them is told, and nothing is lost.
TEST_F(Lists, TellTheSecond) {
  const std::string shown = version_of(bob_, kNear), group = version_of(bob_, kGroup);
  save(ada_, kNear, points("H2.3", 2));
  EXPECT_TRUE(refusal([&] {
                bob_.save(kNear, shown, points("H2.3", 0));
              }).starts_with("ada has decided this meanwhile, at "));
  EXPECT_EQ(decisions(), "ann points H2.3: 2 (computed: 0): why (ada)\n");
  record_.decide("di", {DecisionKind::points, "H3.1", 1, 0, "alone"});
  EXPECT_EQ(refusal([&] { bob_.save(kGroup, group); }), "This has changed meanwhile; look at it again");
  record_.put({made_result("ann", {made_exercise("H2"), made_exercise("S1")})});
  EXPECT_EQ(refusal([&] { bob_.save(kNear, version_of(bob_, "conflict/H2.3/ann")); }).substr(0, 31),
            "This is not in the list any mor");
  record_.decide("ann", {DecisionKind::points, "S1", 1, 0, "elsewhere"});
  save(bob_, kGroup);
  EXPECT_EQ(ada_.find(kGroup)->decided_by, "bob");
}

TEST_F(Lists, TakeBackWhatWasSavedLast) {
  record_.decide("ann", {DecisionKind::points, "H2.3", 1, 0, "before"});
  const std::string before = decisions();
  save(ada_, kGroup, [](Record& record, const std::string& name) {
    record.decide(name, {DecisionKind::comment, "H3", 0, 0, "a sign"});
  });
  save(ada_, kNear, points("H2.3", 2));
  EXPECT_EQ(ada_.undo(), kNear);
  EXPECT_EQ(ada_.undo(), kGroup);
  EXPECT_EQ(decisions(), before);
  EXPECT_EQ(ada_.undo(), "");
  EXPECT_FALSE(bob_.find(kNear)->is_decided());
  EXPECT_EQ(record_.log("ann").back().did, "took back");

  // An item's owner stays, also one that it got since.
  record_.put({made_result("flo", {made_exercise("H1", {{1, 2}})})});
  const std::string flo = "near-threshold/H1/flo";
  save(ada_, flo);
  bob_.share({"bob"}, ShareBy::evenly);
  EXPECT_EQ(ada_.undo(), flo);
  EXPECT_EQ(bob_.find(flo)->owner, "bob");

  // A comment that another has used meanwhile stays with that one.
  const auto say = [](Record& record, const std::string& name) {
    record.decide(name, {DecisionKind::comment, "", 0, 0, "a sign"});
  };
  save(ada_, kNear, say);
  save(bob_, kGroup, say);
  EXPECT_EQ(ada_.undo(), kNear);
  EXPECT_EQ(record_.decisions("cy").size(), 1U);

  save(ada_, kNear, points("H2.3", 2));
  save(bob_, kNear, points("H2.3", 0));
  EXPECT_TRUE(refusal([&] { ada_.undo(); }).starts_with("Others have changed this since"));
  EXPECT_EQ(record_.decisions("ann").front().number, 0);
  bob_.reopen(kNear);
  EXPECT_FALSE(ada_.find(kNear)->is_decided());
}

// To accept an item about a decision is to say that it still holds; if its place is gone, it goes.
TEST_F(Lists, AcceptADecisionAsItIs) {
  record_.decide("ann", {DecisionKind::points, "H2.3", 1, 0, "why"});
  record_.decide("ann", {DecisionKind::points, "S1", 3, 0, "why"});
  record_.put({made_result("ann", {made_exercise("H2")})});
  for (const char* key : {"conflict/H2.3/ann", "conflict/S1/ann"}) {
    save(ada_, key);
    EXPECT_FALSE(ada_.find(key)) << key;
  }
  EXPECT_EQ(decisions(), "ann points H2.3: 1 (computed: 2): why (ada)\n");
  EXPECT_EQ(ada_.undo(), "conflict/S1/ann");
  EXPECT_EQ(record_.decisions("ann").size(), 2U);

  // Points that a place is not worth any more can't hold.
  ExerciseResult less = made_exercise("H2");
  less.cases[2].max_points = less.cases[2].points = 0.5;
  record_.put({made_result("ann", {less})});
  const std::string key = "conflict/H2.3/ann";
  EXPECT_THROW(save(ada_, key), BadInput);
  EXPECT_EQ(record_.decisions("ann").size(), 2U);
}

TEST_F(Lists, SayWhoHasAnItemOpen) {
  EXPECT_EQ(bob_.open(kNear), "");
  EXPECT_EQ(bob_.open(kNear), "") << "it is his own";
  EXPECT_EQ(ada_.open(kNear), "bob");
  now_ += kOpenFor.count();
  EXPECT_EQ(ada_.open(kNear), "bob");
  ++now_;
  EXPECT_EQ(ada_.open(kNear), "") << "bob has gone";
  EXPECT_EQ(bob_.open(kNear), "ada");
  ada_.open(kGroup);
  EXPECT_EQ(bob_.open(kNear), "") << "ada has another one open";
  bob_.open("");
  EXPECT_EQ(ada_.open(kNear), "");
}

TEST_F(Lists, KeepWhatWasDecidedThroughARegrade) {
  save(ada_, kGroup);
  Record stage(temporary_.path(), kStage);
  stage.begin_stage("another suite");
  for (const std::string& name : record_.names()) {
    SubmissionResult result = record_.find(name).value().result;
    if (name == "ann") result.exercises[0] = made_exercise("H2");
    stage.put({result});
  }
  EXPECT_TRUE(bob_.find(kNear)) << "the old results count until all new ones are there";
  ASSERT_TRUE(record_.take_stage().empty());
  EXPECT_FALSE(bob_.find(kNear));
  EXPECT_EQ(bob_.find(kGroup)->decided_by, "ada");
}

TEST_F(Lists, KeepNothingOfAPersonWhoIsForgotten) {
  ada_.share({"ada", "bob"}, ShareBy::evenly);
  EXPECT_EQ(bob_.find(kNear)->owner, "ada");
  EXPECT_EQ(bob_.find(kGroup)->owner, "bob");
  save(ada_, kNear);
  const auto exported = [&] { return record_.export_json().find("\"whose\": \"ann\"") != std::string::npos; };
  EXPECT_TRUE(exported());
  record_.forget("ann");
  EXPECT_FALSE(exported());
  EXPECT_FALSE(bob_.find(kNear));
  EXPECT_EQ(refusal([&] { ada_.undo(); }).substr(0, 11), "Others have");
  for (const auto& [row, kept] : DeskRows(record_).all()) EXPECT_NE(row.person, "ann");
}

// Each planted case is an item. After a decision the list costs little: 180 results were read once.
TEST(MadeClass, IsListedQuicklyAfterEachDecision) {
  hair::TemporaryFolder folder("made-class");
  Record record(folder.path());
  const std::vector<Planted> planted = put_made_class(record);
  const double start = timing::process_cpu_seconds();
  ItemList list(record, "ada");
  for (const Planted& one : planted) EXPECT_TRUE(list.find(one.key)) << one.key;
  const double reading = timing::process_cpu_seconds() - start, before = timing::process_cpu_seconds();
  for (const Planted& one : planted) save(list, one.key);
  const double seconds = (timing::process_cpu_seconds() - before) / static_cast<double>(planted.size());
  EXPECT_LT(seconds, reading / 3) << "seconds for a decision and the list after it";
  std::cout << 1000 * seconds << " ms of CPU time for a decision and the list after it\n";
  record.put({made_result("p020", {made_exercise("S1")})});
  EXPECT_TRUE(list.find("changed//p020"));
  EXPECT_FALSE(list.find("changed//p021"));
}

}  // namespace
}  // namespace grader::review
