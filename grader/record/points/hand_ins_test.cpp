// STAFF ONLY. Tests that a course file names its hand-ins, and that each has results, decisions and
// lateness of its own in one record.
#include "grader/record/points/hand_ins.h"

#include <gtest/gtest.h>

#include <fstream>

#include "grader/course/input.h"
#include "grader/record/record.h"
#include "grader/record/schema.h"
#include "grader/result/result_fields.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_refusal.h"

namespace grader::inline record {
namespace {

using tests::says;

namespace fs = std::filesystem;

class HandIns : public testing::Test {
 protected:
  HandIns() {
    for (const char* id : {"S1", "S2", "H1", "H2", "H3"}) {
      Exercise exercise;
      exercise.id = id;
      course_.exercises.push_back(exercise);
    }
    course_.exercises[1].role = Role::optional;
    course_.exercises[4].role = Role::given;
  }
  std::vector<CourseHandIn> read(const std::string& keys) const {
    std::ofstream(file_) << "{\"exercises\": {}, " << keys << "}";
    return read_hand_ins(course_, file_);
  }
  hair::TemporaryFolder temporary_{"hand-ins"};
  const fs::path dir_ = temporary_.path(), file_ = dir_ / "course.json";
  Course course_;
};

TEST_F(HandIns, ShareTheCommonRulesAndHaveTheirOwn) {
  const std::vector<CourseHandIn> all = read(
      R"("hand_in": {"zone": "Europe/Berlin", "free_days": 2},
         "hand_ins": {"week 3": {"exercises": ["H1", "H2"], "due": "2025-03-18 23:59", "free_days": 1, "column": "W3"},
                      "Übung 1": {"exercises": ["S1"]}})");
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].name, "week 3");
  EXPECT_EQ(all[0].rules.zone, "Europe/Berlin");
  EXPECT_EQ(all[0].rules.free_days, 1);
  EXPECT_EQ(all[0].rules.column, "W3");
  EXPECT_EQ(all[0].rules.exercises, (std::vector<std::string>{"H1", "H2"}));
  EXPECT_EQ(all[1].rules.free_days, 2);
  EXPECT_EQ(all[1].rules.due, "");
  EXPECT_EQ(folder_of_hand_in(all[0].name) + " " + folder_of_hand_in(all[1].name), "week_3 Ubung_1");
  EXPECT_EQ(folder_of_hand_in("../x") + " " + folder_of_hand_in("-r"), "___x x-r");

  EXPECT_EQ(read_hand_in(course_, file_, "week 3").rules, all[0].rules);
  EXPECT_TRUE(says(tests::refusal<BadInput>([&] { read_hand_in(course_, file_, ""); }),
                   "course.json: has several hand-ins; name one by --hand-in: \"week 3\", "));
  EXPECT_TRUE(says(tests::refusal<BadInput>([&] { read_hand_in(course_, file_, "week 4"); }),
                   "has no hand-in \"week 4\"; there are"));
  EXPECT_EQ(read(R"("hand_in": {"due": "2025-03-18 23:59"})").at(0).rules.due, "2025-03-18 23:59");
  EXPECT_TRUE(
      says(tests::refusal<BadInput>([&] { read_hand_in(course_, file_, "week 3"); }), "leave out --hand-in"));
  EXPECT_EQ(read_hand_ins(course_, {}).at(0).rules, HandInRules{});
  EXPECT_EQ(
      read(R"("hand_in": {"by_hand": {"oral": {"points": 10, "title": "Oral"}, "style": {"points": 0.5}}})")
          .at(0)
          .rules.by_hand,
      (std::map<std::string, ByHand>{{"oral", {10, "Oral"}}, {"style", {0.5, ""}}}));
}

TEST_F(HandIns, ThatAreWrittenWrongAreRefusedInOneLine) {
  const struct {
    const char *keys, *refusal;
  } rows[] = {
      {R"("hand_ins": {})", "hand_ins: is empty"},
      {R"("hand_ins": {"a": {}})", "hand_ins.a: names no exercises"},
      {R"("hand_ins": {"a": {"exercises": []}})", "hand_ins.a.exercises: is empty"},
      {R"("hand_ins": {"a": {"exercises": ["S1", "X9"]}})", "hand_ins.a.exercises[1]: there is no such"},
      {R"("hand_ins": {"a": {"exercises": ["H3"]}})", "hand_ins.a.exercises[0]: is given"},
      {R"("hand_ins": {"a": {"exercises": ["S1"]}, "b": {"exercises": ["S1"]}})",
       "hand_ins.b.exercises[0]: S1 is in \"a\", too"},
      {R"("hand_ins": {"a b": {"exercises": ["S1"]}, "a_B": {"exercises": ["H1"]}})", "has the folder"},
      {R"("hand_ins": {"": {"exercises": ["S1"]}})", "is no name of a hand-in"},
      {R"("hand_ins": {"a": {"exercises": ["S1"], "zone": "Berlin"}})", "hand_ins.a.zone: \"Berlin\""},
      {R"("hand_ins": {"a": {"exercises": ["S1"], "late": 1}})", "hand_ins.a"},
      {R"("hand_ins": {"a": {"exercises": ["S1"], "free_days_in_all": 1}})", "write it in \"hand_in\""},
      {R"("hand_in": {"due": "2025-03-04 23:59"}, "hand_ins": {"a": {"exercises": ["S1"]}})",
       "hand_in: has what all of \"hand_ins\" share"},
      {R"("hand_in": {"by_hand": {"oral": 10}})", "by_hand.oral"},
      {R"("hand_in": {"by_hand": {"oral": {"title": "x"}}})", "points"},
      {R"("hand_in": {"by_hand": {"oral": {"points": 0}}})", "by_hand.oral.points"},
      {R"("hand_in": {"by_hand": {"oral": {"points": 1e9}}})", "by_hand.oral.points"},
      {R"("hand_in": {"by_hand": {"S1": {"points": 1}}})", "is an exercise"},
      {R"("hand_in": {"by_hand": {"all": {"points": 1}}})", "is no id"},
      {R"("hand_in": {"by_hand": {"H2.1": {"points": 1}}})", "is no id"},
      {R"("hand_in": {"by_hand": {"=x": {"points": 1}}})", "is no id"},
      {R"("hand_in": {"by_hand": {"oral": {"points": 1, "title": "a\nb"}}})", "title"},
      {R"("hand_in": {"exercises": ["S1"]})", "hand_in.exercises: belongs to"},
  };
  for (const auto& row : rows)
    EXPECT_TRUE(says(tests::refusal<BadInput>([&] { read(row.keys); }), row.refusal)) << row.keys;
}

SubmissionResult result_of(const std::string& name, const std::string& exercise, double points) {
  SubmissionResult result;
  result.name = name;
  result.origin = "hand-in /" + name + exercise;
  result.exercises.resize(1);
  result.exercises[0].id = exercise;
  result.exercises[0].points = points;
  result.exercises[0].max_points = 10;
  result.exercises[0].pictures = {{"1 s", 0, 0, "picture of " + name + exercise, "the reference's", ""}};
  return result;
}

TEST_F(HandIns, HaveTheirOwnResultsAndDecisionsOfOnePerson) {
  Record first(dir_, "week 1"), second(dir_, "week 2");
  const Owner pair{.name = "pair", .group = true, .members = {{.id = "1"}, {.id = "2"}}};
  first.put_people({{"alice", {.name = "alice"}, "folders"}, {"pair", pair, "gradescope"}});
  second.put_people({{"alice", {.name = "alice"}, "folders"}, {"renamed", pair, "gradescope"}});
  EXPECT_EQ(second.drawn_from("alice"), "alice");
  EXPECT_EQ(second.drawn_from("renamed"), "pair") << "people have one seed in all hand-ins";
  first.put({result_of("alice", "S1", 4)}, {"2025-03-04 10:00:00"});
  second.put({result_of("alice", "H1", 7)}, {"2025-03-11 10:00:00"});
  first.put({result_of("alice", "S1", 5)}, {"2025-03-04 11:00:00"});
  first.put({result_of("bob", "S1", 1)});
  second.set_made_by("{\"2\": 2}");
  second.decide("alice", {DecisionKind::points, "H1", 9, 0, "why"});

  EXPECT_EQ(first.find("alice")->result, result_of("alice", "S1", 5)) << "the latest of this hand-in";
  EXPECT_EQ(second.find("alice")->result, result_of("alice", "H1", 7));
  EXPECT_EQ(points(second.find_decided("alice")->result), 9);
  EXPECT_TRUE(first.decisions("alice").empty());
  EXPECT_EQ(first.made_by(), "");
  EXPECT_EQ(first.names(), (std::vector<std::string>{"alice", "bob"}));
  EXPECT_EQ(second.names(), (std::vector<std::string>{"alice"}));
  EXPECT_EQ(second.rows().at("alice").origin, "hand-in /aliceH1");
  EXPECT_EQ(first.log("alice").size(), 2U);
  EXPECT_EQ(second.log("alice").size(), 2U) << "graded, decided";
  EXPECT_EQ(second.costs().submissions.size(), 1U);
  EXPECT_EQ(second.hand_ins().size(), 1U);
  EXPECT_EQ(second.hand_ins(Record::Of::course).size(), 2U);
  EXPECT_EQ(second.totals().at("alice").points, 9);
  EXPECT_FALSE(
      says(second.export_json(), "bob\": {\n   \"drawn_from\": \"bob\",\n   \"hand_ins\": [\n    {"));
  EXPECT_EQ(second.pages(), dir_ / "week_2");
  EXPECT_TRUE(Record(dir_).names().empty());
  EXPECT_EQ(Record(dir_).pages(), dir_);
  first.set_handed_in("alice", {"2025-03-05 10:00:00"});
  second.set_handed_in("alice", {"2025-03-12 10:00:00"});
  EXPECT_TRUE(says(first.export_json(), "\"handed_in\": \"2025-03-05 10:00:00\""));
  EXPECT_TRUE(says(second.export_json(), "\"handed_in\": \"2025-03-12 10:00:00\""));
  EXPECT_TRUE(says(tests::refusal<BadInput>([&] { Record(dir_, "Week_2").put({result_of("x", "S1", 1)}); }),
                   "give \"Week_2\" another"));
}

// Records of version 7 have no share.
TEST_F(HandIns, OfARecordThatBeganWithoutAShareOfExtraCreditHaveNone) {
  SubmissionResult alice = result_of("alice", "S1", 10);
  alice.exercises.push_back(alice.exercises.front());
  alice.exercises[0].points = 2;
  alice.exercises[1].extra_credit = true;
  const auto begin_with_version_7 = [&](const std::string& people) {
    fs::remove(dir_ / kRecordFile);
    Database database(dir_ / kRecordFile);
    migrate(database, {migrations().front()});
    database.run_all(people);
  };
  const auto total = [&](const std::string& hand_in, std::optional<double> share) {
    HandInRules rules;
    rules.extra_credit_share = share;
    Record record(dir_, hand_in);
    record.set_rules(rules);
    record.put({alice});
    const double reached = points(record.find_decided("alice").value().result);
    EXPECT_EQ(points(record.find_under("alice", rules, {}).value()), reached);
    EXPECT_EQ(record.totals().at("alice").points, reached);
    return reached;
  };
  EXPECT_EQ(total("week 1", {}), 3);
  begin_with_version_7("INSERT INTO people (name, drawn_from) VALUES ('bob', 'bob')");
  EXPECT_EQ(total("week 1", {}), 10) << "all counts, up to the full points";
  EXPECT_EQ(total("week 2", {}), 10) << "and in hand-ins that are new";
  EXPECT_EQ(total("week 1", 0.2), 4) << "unless the course file says a share";
  EXPECT_EQ(total("week 1", {}), 10);
  begin_with_version_7("");
  EXPECT_EQ(total("week 1", {}), 3) << "nothing was begun there";
}

// The order of due dates differs from that of names.
TEST_F(HandIns, UseTheCoursesFreeDaysInTheOrderOfTheirDueDates) {
  const auto due = [](const char* day) {
    HandInRules rules;
    rules.due = std::string(day) + " 23:59";
    rules.late_per_cent_a_day = 10;
    rules.free_days_in_all = 3;
    return rules;
  };
  Record b(dir_, "b"), a(dir_, "a"), c(dir_, "c");
  b.set_rules(due("2025-03-04"));
  a.set_rules(due("2025-03-11"));
  c.set_rules(due("2025-03-18"));
  EXPECT_EQ(a.named_hand_ins(), (std::vector<std::string>{"b", "a", "c"}));
  c.put({result_of("alice", "H1", 10)}, {"2025-03-19 12:00:00"});  // a day late
  EXPECT_EQ(points(c.find_decided("alice")->result), 10) << "a free day";
  a.put({result_of("alice", "S2", 10)}, {"2025-03-13 12:00:00"});  // two days
  b.put({result_of("alice", "S1", 10)}, {"2025-03-06 12:00:00"});  // two days
  EXPECT_EQ(points(b.find_decided("alice")->result), 10) << "two of three";
  EXPECT_EQ(points(a.find_decided("alice")->result), 9) << "one was left, and one day costs";
  EXPECT_EQ(points(c.find_decided("alice")->result), 9) << "none was left";
  EXPECT_EQ(b.find_decided("alice")->result.remarks.at(0),
            "1 of the course's 3 days without a deduction are left after this hand-in");
  EXPECT_EQ(c.find_decided("alice")->result.remarks.at(0),
            "0 of the course's 3 days without a deduction are left after this hand-in");
  b.decide("alice", {DecisionKind::late_days, "", 1, 0, "ill"});
  EXPECT_EQ(points(a.find_decided("alice")->result), 10) << "a day that a person gave saves one";
  b.put({result_of("alice", "S1", 10)}, {"2025-03-04 12:00:00"});
  EXPECT_EQ(points(c.find_decided("alice")->result), 10) << "the latest version of each counts";
  b.put({result_of("bob", "S1", 10)}, {"2025-03-20 12:00:00"});  // 16 days
  c.put({result_of("bob", "H1", 10)}, {"2025-03-18 12:00:00"});
  EXPECT_EQ(points(c.find_decided("bob")->result), 10) << "who is not late needs none";
}

}  // namespace
}  // namespace grader::record
