// STAFF ONLY. Tests comments that several people have, requests, and points by hand, in the record.
#include "grader/record/comments.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "grader/course/input.h"
#include "grader/record/record.h"
#include "grader/record/schema.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_refusal.h"

namespace grader::inline record {
namespace {

using tests::says;

// H2 has 1 of 3 and 4 of 5 points, and S1 2 of 2.
SubmissionResult student(const std::string& name) {
  ExerciseResult h2, s1;
  h2.id = "H2";
  h2.points = 5;
  h2.max_points = 8;
  h2.cases = {{"Easy", Status::passed, 1, 3, "", ""}, {"Hard", Status::partly, 4, 5, "", ""}};
  h2.source = "int a;\r\nint b;\n<script>";
  s1.id = "S1";
  s1.points = s1.max_points = 2;
  SubmissionResult result;
  result.name = name;
  result.exercises = {h2, s1};
  return result;
}

class Comments : public testing::Test {
 protected:
  Comments() {
    for (const char* name : {"ada", "ben", "cem"}) record_.put({student(name)});
  }
  SubmissionResult now(const std::string& name) { return record_.find_decided(name).value().result; }
  void comment(const std::string& name, const std::string& place, const std::string& text, double points = 0,
               std::int64_t id = 0) {
    record_.decide(
        name, {.kind = DecisionKind::comment, .place = place, .number = points, .why = text, .comment = id});
  }
  template <class Change>
  std::string refusal(const Change& change) {
    return tests::refusal<BadInput>(change);
  }

  hair::TemporaryFolder temporary_{"comments"};
  Record record_{temporary_.path()};
};

TEST_F(Comments, BelongToSeveralAndChangeForAll) {
  comment("ada", "H2.2", "call it n", -1);
  comment("ben", "H2:2", "call it n", -1);    // the same, by its words
  comment("cem", "S1", "", 0, 1);             // and by its id
  comment("cem", "H2.2", "call it n", -0.5);  // other points are another comment
  ASSERT_EQ(record_.comments().size(), 2U);
  EXPECT_EQ(who_have(record_.comment(1)), "ada H2.2, ben H2:2, cem S1");
  EXPECT_EQ(now("ben").exercises[0].said,
            (std::vector<Said>{{"H2:2", "int b;", "The staff say: call it n (-1 point)"}}));
  EXPECT_EQ(record_.change_comment(1, "call it m", -2).text, "call it n");
  EXPECT_EQ(now("ada").exercises[0].said.at(0).text, "The staff say: call it m (-2 points)");
  EXPECT_EQ(points(now("ada")), 5);
  EXPECT_EQ(points(now("ben")), 5);
  EXPECT_EQ(points(now("cem")), 4.5);
  EXPECT_EQ(record_.log("ben").back().detail, "comment H2:2, comment 1 (-2 points): call it m");
  record_.undo("ben", DecisionKind::comment, "H2:2");
  EXPECT_EQ(now("ben"), student("ben"));
  record_.undo("ada", DecisionKind::comment, "H2.2", 1);
  record_.undo("cem", DecisionKind::comment, "S1");
  EXPECT_EQ(who_have(record_.comment(1)), "nobody") << "it can be used again";
}

TEST_F(Comments, GivePointsWithinTheWorthOfAPlace) {
  const struct {
    const char* about;
    std::vector<std::pair<const char*, double>> at;
    double set, easy, hard, all;  // set: points of H2.2 that a person set; -1: none
  } rows[] = {{"taken", {{"H2.2", -1}}, -1, 1, 3, 4},
              {"not below nothing", {{"H2.1", -5}}, -1, 0, 4, 4},
              {"not above its worth", {{"H2.1", 9}}, -1, 3, 4, 7},
              {"in any order", {{"H2.1", -3}, {"H2.1", 2.5}}, -1, 0.5, 4, 4.5},
              {"at a line of the exercise", {{"H2:1", -2}, {"H2", 1}}, -1, 1, 4, 4},
              {"at categories and exercise", {{"H2", -9}, {"H2.2", 1}}, -1, 1, 5, 0},
              {"after points that were set", {{"H2.2", -1}}, 2, 1, 1, 2}};
  for (const auto& [about, at, set, easy, hard, all] : rows) {
    record_.put({student(about)});
    int number = 0;
    for (const auto& [place, points] : at) comment(about, place, std::to_string(++number), points);
    if (set >= 0) record_.decide(about, {DecisionKind::points, "H2.2", set, 0, "because"});
    const ExerciseResult h2 = now(about).exercises[0];
    EXPECT_EQ(h2.cases[0].points, easy) << about;
    EXPECT_EQ(h2.cases[1].points, hard) << about;
    EXPECT_EQ(h2.points, all) << about;
  }
}

TEST_F(Comments, ThatCanNotBeAreRefused) {
  comment("ada", "", "well done");
  const struct {
    const char *place, *text;
    double points;
    std::int64_t id;
    const char* because;
  } cases[] = {{"H2:4", "x", 0, 0, "the file has 3 lines"},
               {"S1:1", "x", 0, 0, "no source of S1"},
               {"H2:0", "x", 0, 0, "is no place"},
               {"H2:", "x", 0, 0, "is no place"},
               {"H2:1x", "x", 0, 0, "is no place"},
               {"H2.1:1", "x", 0, 0, "is no place"},
               {"H2:99999999999999999999", "x", 0, 0, "is no place"},
               {"", "x", 1, 0, "need a place"},
               {"S1", " \n", 0, 0, "the comment is empty"},
               {"S1", "x", std::nan(""), 0, "no number"},
               {"S1", "", 0, 7, "there is no comment 7"}};
  for (const auto& one : cases)
    EXPECT_TRUE(says(refusal([&] { comment("ada", one.place, one.text, one.points, one.id); }), one.because))
        << one.place << ": " << one.because;
  EXPECT_TRUE(says(refusal([&] { record_.change_comment(1, "well done", 1); }), "need a place"));
  EXPECT_TRUE(says(refusal([&] { record_.change_comment(1, "", 0); }), "empty"));
  EXPECT_TRUE(says(refusal([&] {
                     record_.decide("ada", {DecisionKind::points, "H2:1", 1, 0, "x"});
                   }),
                   "a line"));
  EXPECT_EQ(record_.log("ada").size(), 2U) << "the log has what was done alone";
}

TEST_F(Comments, WaitWhenTheirPlaceIsGone) {
  comment("ada", "H2.2", "as before", -1);
  SubmissionResult shorter = student("ada");
  shorter.exercises.erase(shorter.exercises.begin());
  record_.put({shorter});
  EXPECT_EQ(points(now("ada")), 2);
  EXPECT_TRUE(says(record_.conflicts("ada").at(0), "now there is no H2.2"));
}

TEST_F(Comments, AndRequestsFollowTheirCategories) {
  comment("ada", "H2.2", "hard", -1);
  record_.ask("ada", "H2.1", "easy?");
  SubmissionResult turned = student("ada");
  std::swap(turned.exercises[0].cases[0], turned.exercises[0].cases[1]);
  record_.put({turned});
  EXPECT_EQ(now("ada").exercises[0].said.at(0).place, "H2.1");
  EXPECT_EQ(now("ada").exercises[0].said.at(1).place, "H2.2");
  EXPECT_EQ(now("ada").exercises[0].cases[0].points, 3);
  turned.exercises[0].cases[0].name = "Other";
  record_.put({turned});
  EXPECT_EQ(points(now("ada")), 7) << "the comment waits";
  EXPECT_EQ(record_.conflicts("ada").size(), 1U);
}

TEST_F(Comments, AndRequestsAreHostileTextThatGoesWithItsPerson) {
  const std::string text = "<b>=HYPERLINK(\"x\")\n'); DROP TABLE people; --" + std::string(1 << 20, 'z');
  comment("ada", "H2:3", text);
  comment("ada", "S1", "to both");
  comment("ben", "S1", "to both");
  record_.ask("ada", "S1", text);
  record_.answer(1, text);
  EXPECT_EQ(now("ada").exercises[0].said.at(0).code, "<script>");
  EXPECT_EQ(now("ada").exercises[0].said.at(0).text, "The staff say: " + text);
  EXPECT_EQ(record_.requests().at(0).answer, text);
  const auto exported = [&] { return nlohmann::json::parse(record_.export_json()); };
  EXPECT_EQ(exported()["people"]["ada"]["requests"][0]["answer"], text);
  EXPECT_EQ(exported()["comments"].size(), 2U);
  record_.forget("ada");
  EXPECT_TRUE(record_.requests().empty());
  EXPECT_EQ(exported()["comments"].size(), 1U);
  EXPECT_FALSE(says(record_.export_json(), "DROP"));
  EXPECT_EQ(who_have(record_.comments().at(0)), "ben S1");
}

TEST_F(Comments, RequestsAreAnsweredOnce) {
  EXPECT_EQ(record_.ask("ada", "H2:1", "why?"), 1);
  EXPECT_EQ(record_.ask("ada", "H2:1", "why?"), 0) << "a table is entered again when it has grown";
  EXPECT_EQ(record_.ask("ada", "", "all?"), 2);
  const std::string day = record_.now().substr(0, 10);
  EXPECT_EQ(now("ada").exercises[0].said,
            (std::vector<Said>{
                {"H2:1", "int a;", "You asked on " + day + ": why?\nThe staff have not answered yet."}}));
  EXPECT_EQ(record_.answer(1, "therefore").name, "ada");
  EXPECT_EQ(now("ada").exercises[0].said.at(0).text,
            "You asked on " + day + ": why?\nThe staff answered on " + day + ": therefore");
  EXPECT_TRUE(says(refusal([&] { record_.answer(1, "or not"); }), "answered once"));
  EXPECT_TRUE(says(refusal([&] { record_.answer(2, " "); }), "empty"));
  EXPECT_TRUE(says(refusal([&] { record_.answer(3, "x"); }), "there is no request 3"));
  EXPECT_TRUE(says(refusal([&] { record_.ask("ada", "H9", "x"); }), "is no place"));
  EXPECT_TRUE(says(refusal([&] { record_.ask("dan", "H2", "x"); }), "nobody in"));
  EXPECT_EQ(record_.requests().at(0).answer, "therefore");
  EXPECT_EQ(record_.log("ada").back().detail, "1: therefore");
}

// The record is of an older version, and of a hand-in with equal comments.
TEST(OlderRecords, KeepTheirComments) {
  for (const int versions : {1, 2}) {
    const hair::TemporaryFolder folder("older");
    {
      Database database(folder.path() / kRecordFile);
      migrate(database, {migrations().begin(), migrations().begin() + versions});
      database.run_all(R"(
INSERT INTO people (id, name, drawn_from) VALUES (1, 'ada', 'ada'), (2, 'ben', 'ben');
INSERT INTO decisions VALUES (1, 1, 'comment', 'H2', 0, 5, 'good', 'tom', '2025-01-02 10:00:00'),
  (1, 1, 'points', 'S1', 1, 2, 'short', 'tom', '2025-01-02 10:00:00'),
  (1, 2, 'comment', '', 0, 5, 'good', 'eve', '2025-01-01 10:00:00'),
  (1, 2, 'comment', 'S1', 0, 5, 'late', 'eve', '2025-01-03 10:00:00');)");
    }
    Record record(folder.path());
    const std::vector<Comment> all = record.comments();
    ASSERT_EQ(all.size(), 2U);
    EXPECT_EQ(all[0].text + ": " + who_have(all[0]), "good: ada H2, ben");
    EXPECT_EQ(all[1].text + ": " + who_have(all[1]), "late: ben S1");
    record.put({student("ada")});
    EXPECT_EQ(record.find_decided("ada")->result.exercises[0].said.at(0).text, "The staff say: good");
    EXPECT_EQ(record.decisions("ada").at(0).who, "tom");
    EXPECT_EQ(record.decisions("ada").at(1).why, "short");
  }
}

class PointsByHand : public Comments {
 protected:
  PointsByHand() {
    HandInRules rules;
    rules.due = "2025-03-04 23:59";
    rules.late_per_cent_a_day = 10;
    rules.by_hand = {{"oral", {10, "Oral examination"}}, {"style", {2}}};
    record_.set_rules(rules);
    record_.put({student("ada")}, {"2025-03-05 12:00:00"});
  }
  void set(const std::string& place, double number) {
    record_.decide("ada", {DecisionKind::points, place, number, 0, ""});
  }
};

TEST_F(PointsByHand, AreEmptyUntilTheyAreGivenAndBesideTheRules) {
  EXPECT_EQ(max_points(now("ada")), 22);
  EXPECT_EQ(points(now("ada")), 6.3) << "a day late";
  EXPECT_EQ(now("ada").exercises.at(2).status, Status::not_given);
  EXPECT_EQ(now("ada").exercises.at(2).title, "Oral examination");
  comment("ada", "oral", "spoke well", 1);
  EXPECT_EQ(points(now("ada")), 6.3) << "a comment gives nothing before";
  set("oral", 7);
  set("style", 0);
  const SubmissionResult result = now("ada");
  EXPECT_EQ(points(result), 6.3 + 8) << "with the comment's point, and without lateness";
  EXPECT_EQ(result.exercises.at(2).feedback, "The staff gave 7 of 10 points");
  EXPECT_EQ(result.exercises.at(3).status, Status::given);
  EXPECT_EQ(record_.totals().at("ada").max_points, 22);
  EXPECT_TRUE(record_.conflicts("ada").empty());
  EXPECT_EQ(record_.find("ada").value().result, student("ada")) << "nothing is stored with the results";
  record_.put({student("ada")}, {"2025-03-05 12:00:00"});
  EXPECT_EQ(points(now("ada")), 6.3 + 8) << "after a regrade, too";
  EXPECT_TRUE(says(refusal([&] { set("oral", 10.5); }), "oral is worth 10"));
  record_.decide("ada", {DecisionKind::excuse, "style", 0, 0, "ill"});
  EXPECT_EQ(max_points(now("ada")), 20);
  HandInRules less;
  less.by_hand = {{"oral", {5}}};
  record_.set_rules(less);
  EXPECT_EQ(max_points(now("ada")), 15);
  EXPECT_EQ(record_.conflicts("ada").size(), 3U) << "oral is worth less, and style with its excuse is gone";
}

}  // namespace
}  // namespace grader::record
