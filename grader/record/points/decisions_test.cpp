// STAFF ONLY. Tests that decisions of people survive each regrade, and report changed results.
#include "grader/record/points/decisions.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "grader/course/input.h"
#include "grader/record/changes.h"
#include "grader/record/record.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_refusal.h"

namespace grader::inline record {
namespace {

using tests::says;

SubmissionResult alice(double second_category = 1.5) {
  ExerciseResult one, two;
  one.id = "S1";
  one.title = "One";
  one.points = 4;
  one.max_points = 5;
  two.id = "H2";
  two.title = "Two";
  two.points = 3 + second_category;
  two.max_points = 8;
  two.cases = {{"Easy", Status::passed, 3, 3, "All right.", ""},
               {"Hard", Status::partly, second_category, 5, "Not yet.", ""}};
  SubmissionResult result;
  result.name = "alice";
  result.exercises = {one, two};
  return result;
}

class Decisions : public testing::Test {
 protected:
  Decisions() { record_.put({alice()}); }
  SubmissionResult now() { return record_.find_decided("alice").value().result; }
  void decide(DecisionKind kind, const std::string& place, double number = 0,
              const std::string& why = "because") {
    record_.decide("alice", {kind, place, number, 0, why});
  }
  std::string refusal(DecisionKind kind, const std::string& place, double number,
                      const std::string& why = "because") {
    return tests::refusal<BadInput>([&] { decide(kind, place, number, why); });
  }

  hair::TemporaryFolder temporary_{"decisions"};
  Record record_{temporary_.path()};
};

TEST_F(Decisions, SetPointsAndTellTheStudentWhy) {
  decide(DecisionKind::points, "H2.2", 4, "the reference was wrong");
  const SubmissionResult result = now();
  EXPECT_EQ(result.exercises[1].cases[1].points, 4);
  EXPECT_EQ(result.exercises[1].points, 7);
  EXPECT_EQ(points(result), 11);
  EXPECT_EQ(
      result.exercises[1].feedback,
      sentence_for(Status::missing) +
          " Hard: The staff gave 4 of 5 points here, where 1.5 had been computed: the reference was wrong");
  EXPECT_EQ(record_.find("alice").value().result, alice()) << "what was computed stays";
}

TEST_F(Decisions, SurviveEachRegradeAndListWhatHasChanged) {
  decide(DecisionKind::points, "H2.2", 4);
  record_.put({alice()});
  EXPECT_EQ(points(now()), 11);
  EXPECT_EQ(now().decided.at(0).conflict, "");
  record_.put({alice(5)});
  EXPECT_EQ(points(now()), 11) << "a decision is not taken back by itself";
  const std::string conflict =
      user() +
      " set H2.2 to 4 where 1.5 of 5 points had been computed, and now it is 5; set it "
      "again, or unset it";
  EXPECT_EQ(conflicts(alice(5), record_.decisions("alice")), std::vector{"alice: " + conflict});
  EXPECT_EQ(now().decided.at(0).conflict, conflict);
  SubmissionResult shorter = alice();
  shorter.exercises[1].cases.pop_back();
  record_.put({shorter});
  EXPECT_EQ(now().exercises, shorter.exercises);
  EXPECT_TRUE(says(conflicts(shorter, record_.decisions("alice")).at(0), "now there is no H2.2"));
  record_.put({alice(5)});
  decide(DecisionKind::points, "H2.2", 4.5);
  EXPECT_TRUE(conflicts(alice(5), record_.decisions("alice")).empty()) << "it was decided again";
  record_.undo("alice", DecisionKind::points, "H2.2");
  EXPECT_EQ(now(), alice(5));
}

TEST_F(Decisions, OfAnExerciseAndItsCategoryContradict) {
  decide(DecisionKind::points, "H2.2", 2.5);
  decide(DecisionKind::points, "S1", 5);
  EXPECT_EQ(points(now()), 5 + 3 + 2.5);
  decide(DecisionKind::points, "S1", 0);
  EXPECT_EQ(points(now()), 3 + 2.5) << "the later one of a place replaces the earlier one";
  EXPECT_EQ(refusal(DecisionKind::points, "H2", 6),
            "H2: " + user() + " set H2.2 to 2.5 points, and nobody could say which count; unset H2.2 first");
  decide(DecisionKind::comment, "H2", 0, "a word");
  record_.undo("alice", DecisionKind::points, "H2.2");
  decide(DecisionKind::points, "H2", 6);
  EXPECT_TRUE(says(refusal(DecisionKind::points, "H2.2", 2.5), "unset H2 first"));
  const Decision whole = record_.decisions("alice").at(1),
                 part{DecisionKind::points, "H2.2", 2, 1.5, "", "tom"};
  EXPECT_EQ(points(decided(alice(), {part, whole})), 4 + 6 + 0.5) << "as an older record has them";
  EXPECT_EQ(conflicts(alice(), {part, whole}).size(), 1U);
}

TEST_F(Decisions, ExcuseFromAnExerciseOrFromAll) {
  decide(DecisionKind::points, "H2.2", 4);
  decide(DecisionKind::excuse, "H2");
  EXPECT_EQ(points(now()), 4);
  EXPECT_EQ(max_points(now()), 5);
  EXPECT_TRUE(says(refusal(DecisionKind::points, "H2.2", 3), "unset the excuse first"));
  EXPECT_EQ(refusal(DecisionKind::points, "S1", 3), "");
  EXPECT_EQ(now().exercises[0].status, alice().exercises[0].status);
  EXPECT_EQ(now().exercises[1].status, Status::excused);
  decide(DecisionKind::excuse, "");
  EXPECT_EQ(max_points(now()), 0);
}

TEST_F(Decisions, CommentAPlaceOrTheWhole) {
  decide(DecisionKind::comment, "S1", 0, "nicely short");
  decide(DecisionKind::comment, "", 0, "well done");
  decide(DecisionKind::late_days, "", 2, "ill");
  decide(DecisionKind::hold, "", 0, "the student does not read this");
  EXPECT_EQ(now().exercises[0].said, (std::vector<Said>{{"S1", "", "The staff say: nicely short"}}));
  EXPECT_EQ(now().remarks,
            (std::vector<std::string>{"The staff say: well done", "The staff gave you 2 more days: ill"}));
  EXPECT_EQ(points(now()), points(alice()));
  decide(DecisionKind::excuse, "H2");
  record_.undo("alice", DecisionKind::excuse, "");
  EXPECT_EQ(points(now()), points(alice())) << "the only one of its kind needs no place";
  EXPECT_THROW(record_.undo("alice", DecisionKind::excuse, ""), BadInput);
}

TEST_F(Decisions, ThatCanNotBeAreRefusedInOneLine) {
  EXPECT_EQ(refusal(DecisionKind::points, "H2.3", 2),
            "H2.3: is no place in the result of alice; there are S1, H2 (H2.1 to H2.2)");
  EXPECT_EQ(refusal(DecisionKind::points, "H2.2", 5.5),
            "5.5 points: H2.2 is worth 5; write a number from 0 to that");
  EXPECT_NE(refusal(DecisionKind::points, "H2.2", -1), "");
  EXPECT_NE(refusal(DecisionKind::points, "H2.2", std::stod("nan")), "");
  EXPECT_NE(refusal(DecisionKind::points, "", 1), "");
  EXPECT_NE(refusal(DecisionKind::late_days, "", -1), "");
  EXPECT_NE(refusal(DecisionKind::excuse, "H2.2", 0), "");
  EXPECT_TRUE(says(refusal(DecisionKind::points, "H2.2", 2, " "), "--why"));
  EXPECT_EQ(now(), alice());
  EXPECT_THROW(record_.decide("nobody", {DecisionKind::excuse, "", 0, 0, "because"}), BadInput);
  EXPECT_THROW(record_.undo("alice", DecisionKind::points, "H2.2"), BadInput);
  EXPECT_EQ(record_.log("alice").size(), 1U) << "the log has what was done alone";
}

TEST_F(Decisions, ApplyBeforeTheRulesOfTheHandIn) {
  HandInRules rules;
  rules.due = "2025-03-04 23:59";
  rules.late_per_cent_a_day = 10;
  record_.put({alice()}, {"2025-03-06 10:00:00"});
  record_.set_rules(rules);
  rules.extra_credit_share = kExtraCreditShare;
  EXPECT_EQ(record_.rules(), rules);
  decide(DecisionKind::points, "H2.2", 3);
  EXPECT_EQ(points(now()), 10 - 2);
  decide(DecisionKind::late_days, "", 1, "ill");
  EXPECT_EQ(points(now()), 10 - 1);
  EXPECT_EQ(record_.find_decided("alice").value().late, (Lateness{"2025-03-06 10:00:00", 2, 1, 1}));
  record_.put({alice()}, {"2025-03-04 10:00:00"});
  EXPECT_EQ(record_.find_decided("alice").value().late, (Lateness{"2025-03-04 10:00:00", 0, 0, 0}));
  EXPECT_EQ(points(now()), 10) << "the hand-in that was graded last counts";
  record_.put({alice()}, {"2025-03-06 10:00:00"});
  EXPECT_EQ(points(now()), 10 - 1) << "also if it was there before";
  rules.late_per_cent_a_day = 50;
  const auto half_of_h2 = [](SubmissionResult& result) { result.exercises[1].points /= 2; };
  EXPECT_EQ(points(record_.find_under("alice", rules, half_of_h2).value()), 3.5) << "half of 4 + 6 / 2";
  EXPECT_EQ(points(now()), 10 - 1) << "nothing was changed by the question";
}

TEST_F(Decisions, StandInTheLogAndInTheExport) {
  decide(DecisionKind::points, "H2.2", 4, "the reference was wrong");
  record_.undo("alice", DecisionKind::points, "H2.2");
  decide(DecisionKind::comment, "", 0, "well done");
  const std::vector<LogEntry> log = record_.log("alice");
  ASSERT_EQ(log.size(), 4U);
  EXPECT_EQ(log[1].did, "decided");
  EXPECT_EQ(log[1].detail, "points H2.2: 4 (computed: 1.5): the reference was wrong");
  EXPECT_EQ(log[2].did, "took back");
  const nlohmann::json all = nlohmann::json::parse(record_.export_json());
  const nlohmann::json& one = all.at("people").at("alice");
  EXPECT_EQ(one.at("decisions").at(0).at("why"), "well done");
  EXPECT_EQ(one.at("result").at("exercises").at(1).at("id"), "H2");
  EXPECT_EQ(one.at("hand_ins").size(), 1U);
  EXPECT_EQ(one.at("log").size(), 4U);
}

TEST_F(Decisions, ChangesOfALaterGradingAreTold) {
  EXPECT_TRUE(changes(record_.log("alice")).empty());
  record_.put({alice(5)});
  const std::vector<PointsChange> found = changes(record_.log("alice"));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].place, "H2.2");
  EXPECT_EQ(found[0].before, 1.5);
  EXPECT_EQ(found[0].after, 5);
  record_.put({alice(5)});
  EXPECT_TRUE(changes(record_.log("alice")).empty()) << "against the one before";
}

}  // namespace
}  // namespace grader::record
