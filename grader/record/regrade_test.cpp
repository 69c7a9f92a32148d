// STAFF ONLY. Tests that a regrade changes all results or none, and moves no decision to another category.
#include <gtest/gtest.h>

#include <map>

#include "grader/course/input.h"
#include "grader/record/changes.h"
#include "grader/record/record.h"
#include "grader/record/schema.h"
#include "grader/result/json_fields.h"
#include "grader/result/result_fields.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_refusal.h"

namespace grader::inline record {
namespace {

using tests::says;

using Titles = std::vector<std::string>;

// Each category is worth 5, and gives `points`.
SubmissionResult graded(const std::string& name, const Titles& titles, double points = 1, double worth = 5) {
  ExerciseResult exercise;
  exercise.id = "H2";
  exercise.title = "Two";
  for (const std::string& title : titles)
    exercise.cases.push_back({title, Status::partly, points, worth, "Not yet.", ""});
  exercise.points = points * static_cast<double>(titles.size());
  exercise.max_points = worth * static_cast<double>(titles.size());
  exercise.pictures = {{"1 s", 0, 0, "picture of " + name + std::to_string(points), "the reference's", ""}};
  SubmissionResult result;
  result.name = name;
  result.origin = "class /" + name;
  result.exercises = {exercise};
  return result;
}

class Regrade : public testing::Test {
 protected:
  Regrade() {
    for (const char* name : {"ada", "ben"})
      record_.put({graded(name, {"Easy", "Hard"})}, {"2025-03-04 10:15:22", "f"});
    record_.set_made_by("old suite");
  }
  std::unique_ptr<Record> stage(const std::string& made_by = "new suite") const {
    auto stage = std::make_unique<Record>(folder_.path(), kStage);
    stage->begin_stage(made_by);
    return stage;
  }
  void regrade(const Titles& titles, double points = 1, double worth = 5) {
    for (const std::string& name : record_.names())
      stage()->put({graded(name, titles, points, worth)}, {"", "f"});
    EXPECT_EQ(record_.take_stage(), Titles());
  }
  double points_now(const std::string& name = "ada") {
    return points(record_.find_decided(name).value().result);
  }
  std::string asked() {
    std::string lines;
    for (const std::string& line : record_.conflicts("ada")) lines += line + "\n";
    return lines;
  }

  hair::TemporaryFolder folder_{"regrade"};
  Record record_{folder_.path()};
};

TEST_F(Regrade, ChangesAllResultsAtOnceAndKeepsAllElse) {
  record_.decide("ada", {DecisionKind::points, "H2.1", 4, 0, "a talk"});
  HandInRules rules;
  rules.due = "2025-03-03 23:59";
  stage()->set_rules(rules);
  stage()->put({graded("ada", {"Easy", "Hard"}, 2)}, {"", "f"});
  EXPECT_EQ(record_.take_stage(), Titles{"ben"}) << "it waits for ben";
  EXPECT_EQ(record_.find("ada").value().result, graded("ada", {"Easy", "Hard"}));
  EXPECT_EQ(record_.made_by(), "old suite");
  EXPECT_EQ(record_.rules().due, "");
  EXPECT_EQ(record_.hand_ins(Record::Of::course).size(), 2U);
  EXPECT_EQ(record_.log("ada").size(), 2U);
  EXPECT_TRUE(stage()->find("ada")) << "the same regrade goes on";
  EXPECT_FALSE(stage("a third suite")->find("ada")) << "another one begins anew";

  stage()->set_rules(rules);
  regrade({"Easy", "Hard"}, 2);
  EXPECT_EQ(points_now(), 4 + 2);
  EXPECT_EQ(points_now("ben"), 4);
  EXPECT_EQ(record_.made_by(), "new suite");
  EXPECT_EQ(record_.rules().due, rules.due);
  EXPECT_EQ(record_.handed_in("ada"), "2025-03-04 10:15:22") << "the table of times is not given again";
  EXPECT_EQ(record_.log("ada").size(), 3U);
  EXPECT_EQ(Database(folder_.path() / kRecordFile).number("SELECT count(*) FROM pictures"), 3);
  EXPECT_EQ(Database(folder_.path() / kRecordFile).number("SELECT count(*) FROM assignments"), 1);
}

TEST_F(Regrade, LeavesOutAStagedResultThatIsOfThePast) {
  for (const char* name : {"ada", "ben"}) stage()->put({graded(name, {"Easy"}, 3)}, {"", "f"});
  record_.put({graded("ada", {"Easy", "Hard"})}, {"2025-03-05 10:00:00", "newer files"});
  EXPECT_EQ(record_.take_stage(), Titles{"ada"});
  stage()->put({graded("ada", {"Easy"}, 3)}, {"", "newer files"});
  record_.set_handed_in("ben", {"2025-03-06 10:00:00", "f"});
  EXPECT_EQ(record_.take_stage(), Titles{"ben"});
  record_.forget("ben");
  EXPECT_EQ(record_.take_stage(), Titles());
  EXPECT_EQ(record_.names(), Titles{"ada"});
  EXPECT_EQ(record_.handed_in("ada"), "2025-03-05 10:00:00");
}

// ada has 3 points for the second category, where 1 was computed.
TEST_F(Regrade, ADecisionFollowsItsCategoryOrWaits) {
  const struct {
    Titles titles;
    std::string place;  // is the decision's then
    double points;
  } rows[] = {{{"Easy", "Hard"}, "H2.2", 4},
              {{"New", "Easy", "Hard"}, "H2.3", 5},
              {{"Hard", "Easy"}, "H2.1", 4},
              {{"Easy", "Harder"}, "H2.2 Hard", 2},
              {{"Easy", "Hard, small", "Hard, large"}, "H2.2 Hard", 3},
              {{"Easy"}, "H2.2 Hard", 1},
              {{}, "H2.2 Hard", 0}};
  for (const auto& [titles, place, points] : rows) {
    SCOPED_TRACE(testing::PrintToString(titles));
    regrade({"Easy", "Hard"});
    record_.decide("ada", {DecisionKind::points, "H2.2", 3, 0, "a talk"});
    record_.decide("ada", {DecisionKind::comment, "H2.2", 0, 0, "a word"});
    regrade(titles);
    EXPECT_EQ(record_.decisions("ada").at(0).place, place);
    EXPECT_EQ(points_now(), points);
    const bool waits = place.find(' ') != place.npos;
    EXPECT_EQ(std::ranges::count(asked(), '\n'), waits ? 2 : 0) << asked();
    EXPECT_EQ(asked().find("now there is no " + place) != std::string::npos, waits) << asked();
    EXPECT_EQ(record_.find_decided("ada")->result.exercises[0].said.empty(), waits);
    record_.undo("ada", DecisionKind::points, place);
    record_.undo("ada", DecisionKind::comment, "");
  }
}

TEST_F(Regrade, AskedDecisionsEndOnceAPersonSetsOrTheCategoryIsBack) {
  record_.decide("ada", {DecisionKind::points, "H2.1", 5, 0, "a talk"});
  record_.decide("ada", {DecisionKind::points, "H2.2", 3, 0, "a talk"});
  regrade({"Easy", "Harder"});
  EXPECT_EQ(points_now(), 5 + 1);
  record_.decide("ada", {DecisionKind::points, "H2.2", 2, 0, "again"});
  EXPECT_EQ(asked(), "");
  EXPECT_EQ(points_now(), 5 + 2);
  regrade({"Hard", "Easy"});
  EXPECT_TRUE(says(asked(), "no H2.2 Harder"));
  EXPECT_EQ(points_now(), 5 + 1);
  regrade({"Hard", "Easy", "Harder"});
  EXPECT_EQ(asked(), "");
  EXPECT_EQ(points_now(), 1 + 5 + 2);
  regrade({"Hard", "Easy", "Harder"}, 1, 4);
  EXPECT_EQ(points_now(), 1 + 4 + 2) << "no category gives more than it is worth";
  EXPECT_TRUE(says(asked(), "1 of 5 points had been computed, and now it is worth 4; set it again"));
}

TEST_F(Regrade, PublishedTotalsAreComparedByCategory) {
  const auto publish = [&](const std::string& by) {
    Published one = published(record_.find_decided("ada")->result);
    one.by = by;
    record_.put_published({{"ada", one}});
  };
  const auto told = [&] {
    return change_in_words(record_.published("ada").value(), published(record_.find_decided("ada")->result));
  };
  EXPECT_FALSE(record_.published("ada"));
  publish("feedback moodle");
  EXPECT_EQ(told(), "");
  EXPECT_EQ(record_.published("ada")->by, "feedback moodle");
  regrade({"New", "Easy", "Hard"});
  EXPECT_EQ(told(), "Your total was 2 of 10 points and is 3 of 15 now: H2.1 New not there -> 1.");
  publish("gradebook moodle");
  record_.decide("ada", {DecisionKind::points, "H2.2", 4, 0, "a talk"});
  EXPECT_EQ(told(), "Your total was 3 of 15 points and is 6 of 15 now: H2.2 Easy 1 -> 4.");
  record_.undo("ada", DecisionKind::points, "H2.2");
  EXPECT_EQ(told(), "");
  record_.decide("ada", {DecisionKind::points, "H2", 4.5, 0, "a talk"});
  EXPECT_EQ(told(), "Your total was 3 of 15 points and is 4.5 of 15 now: H2 Two 3 -> 4.5.");
  record_.undo("ada", DecisionKind::points, "");
  regrade({"A", "B", "C"}, 2);
  EXPECT_EQ(told(), "Your total was 3 of 15 points and is 6 of 15 now: H2 Two 3 -> 6.") << "six categories";
}

class OfAnOlderVersion : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(SevenAndEight, OfAnOlderVersion, testing::Values(1, 2));  // count steps

TEST_P(OfAnOlderVersion, ARecordsDecisionsFollowTheirCategories) {
  const hair::TemporaryFolder folder("older");
  {
    Database database(folder.path() / kRecordFile);
    migrate(database, {migrations().begin(), migrations().begin() + GetParam()});
    database.run("INSERT INTO people (id, name, drawn_from) VALUES (1, 'ada', 'ada')");
    database.run(
        "INSERT INTO results VALUES (1, 1, '', ?, '', '', '{}')",
        {json_text(graded("ada", {"Easy", "Hard"}), -1, {[](const std::string&) { return ""; }, {}})});
    for (const std::string row : {"'points', 'H2.2', 3", "'comment', 'H2', 0"})
      database.run("INSERT INTO decisions VALUES (1, 1, " + row +
                   ", 1, 'a talk', 'tom', '2025-03-04 10:15:22')");
  }
  Record record(folder.path());
  EXPECT_EQ(points(record.find_decided("ada").value().result), 4);
  const std::vector<Decision> found = record.decisions("ada");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].title, "") << "an exercise keeps its name";
  EXPECT_EQ(found[1].title, "Hard");
  EXPECT_EQ(found[1].worth, 5);
  record.put({graded("ada", {"Hard", "Easy"})});
  EXPECT_EQ(record.decisions("ada").at(1).place, "H2.1");
}

}  // namespace
}  // namespace grader::record
