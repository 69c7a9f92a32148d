// STAFF ONLY. Tests that a record knows the owners of hand-ins and missing people, their times and marks, and
// forgets them.

#include <gtest/gtest.h>

#include "grader/course/input.h"
#include "grader/record/record.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"

namespace grader::inline record {
namespace {

TEST(PeopleInTheRecord, ComeBackAndMakeTheClass) {
  const hair::TemporaryFolder folder("owners");
  const Owner team{.name = "Teäm",
                   .id = "7",
                   .email = "",
                   .group = true,
                   .members = {{"A", "1", "a@u.de"}, {"B", "2", ""}}};
  const std::vector<HandIn> hand_ins{
      {"doe", {.name = "", .id = "x", .email = "", .anonymous = true}, "canvas"}, {"team", team, "moodle"}};
  const Roster roster(parse_csv("id,name,email,section,group\n1,A,a@u.de,x,Team 7\n3,Zoë,,y,\n", "r.csv"));
  {
    Record record(folder.path());
    EXPECT_FALSE(record.class_list());
    record.put_people(hand_ins, roster.people());
    EXPECT_TRUE(record.hand_ins().empty());  // nothing is graded
    for (const HandIn& one : hand_ins) {
      Recorded graded;
      graded.result.name = one.name;
      record.put(graded);
    }
  }
  Record record(folder.path());
  record.put_people({hand_ins[1]});  // the others stay
  record.put_people({hand_ins[1], {"new", {.name = "New"}, "canvas"}}, {}, "team");
  EXPECT_THROW(record.drawn_from("new"), BadInput) << "nobody asked for this one";
  ASSERT_EQ(record.roster().value().size(), 2u);
  EXPECT_EQ(record.roster()->at(0).group, "Team 7");
  EXPECT_EQ(record.roster()->at(1).group, "");
  const std::vector<HandIn> found = record.hand_ins();
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].owner.id, "x");
  EXPECT_TRUE(found[0].owner.anonymous);
  EXPECT_EQ(found[1].system, "moodle");
  EXPECT_EQ(found[1].owner.name, "Teäm");
  ASSERT_EQ(found[1].owner.members.size(), 2u);
  EXPECT_EQ(found[1].owner.members[0].email, "a@u.de");

  const std::optional<ClassList> list = record.class_list();
  ASSERT_TRUE(list && list->rows.size() == 2);
  EXPECT_EQ(list->rows[0].hand_ins, std::vector<std::string>{"team"});
  ASSERT_EQ(list->absent().size(), 1u);
  EXPECT_EQ(list->absent()[0]->name, "Zoë");
  EXPECT_EQ(list->absent()[0]->section, "y");
  EXPECT_EQ(list->strangers.size(), 2u);

  record.forget("team");
  record.shred();
  EXPECT_EQ(record.class_list()->rows.size(), 1u);
  for (const auto& file : std::filesystem::directory_iterator(folder.path()))
    EXPECT_EQ(hair::bytes_of(file.path()).find("a@u.de"), std::string::npos) << file.path();
}

TEST(PeopleInTheRecord, AreNotMadeBlindOnceTheyHaveNames) {
  const hair::TemporaryFolder folder("names");
  Record record(folder.path());
  Recorded one;
  one.result.name = "alice";
  record.put(one);
  EXPECT_THROW(record.set_blind(), BadInput);
  EXPECT_FALSE(record.is_blind());
}

class HandedInVersions : public testing::Test {
 protected:
  static Recorded graded(const std::string& name) {
    Recorded one;
    one.result.name = name;
    return one;
  }

  hair::TemporaryFolder temporary_{"handed in"};
  const std::filesystem::path dir_ = temporary_.path();
};

// A table of times is not given with each grading.
TEST_F(HandedInVersions, KeepTheTimeOfTheSameFiles) {
  Record record(dir_, "week 1");
  std::string before;
  const auto put = [&](const HandedIn& handed_in) {
    before = record.put(graded("alice"), handed_in);
    return record.handed_in("alice");
  };
  EXPECT_EQ(put({"", "files"}), "");
  EXPECT_EQ(put({"2025-03-04 10:00:00", "files"}), "2025-03-04 10:00:00");
  EXPECT_EQ(put({"", "files"}), "2025-03-04 10:00:00");
  EXPECT_EQ(put({"", "others"}), "") << "another version";
  EXPECT_EQ(put({"2025-03-05 10:00:00", "files"}), "2025-03-05 10:00:00");
  EXPECT_EQ(put({"", ""}), "") << "nobody knows what was handed in";
  EXPECT_EQ(put({"", "files"}), "2025-03-05 10:00:00") << "the first version again";
  EXPECT_EQ(put({"-", "files"}), "-") << "a corrected table";
  EXPECT_EQ(before, "2025-03-05 10:00:00");
  EXPECT_EQ(put({"", "files"}), "-");
  EXPECT_EQ(record.set_handed_in("alice", {"2025-03-05 10:00:00", "files"}), "-");
  Record(dir_, "week 2").put(graded("alice"), {"", "files"});
  EXPECT_EQ(Record(dir_, "week 2").handed_in("alice"), "");
  record.put(graded("bob"), {"", "files"});
  EXPECT_EQ(record.handed_in("bob"), "") << "alice's time";
  record.set_handed_in("alice", {"", "files"});
  EXPECT_EQ(record.handed_in("alice"), "2025-03-05 10:00:00");
}

TEST_F(HandedInVersions, KnowWhatTheLearningSystemMarkedAsLate) {
  Record record(dir_);
  record.put(graded("alice"), {"", "files", true});
  record.put(graded("bob"), {"", "files", false});
  EXPECT_TRUE(record.find_decided("alice")->late.marked);
  EXPECT_FALSE(record.find_decided("bob")->late.marked);
  const std::string json = record.export_json();
  EXPECT_LT(json.find("\"marked_late\": true"), json.find("\"bob\""));
  EXPECT_NE(json.find("\"marked_late\": false"), std::string::npos);
  // This is a later download of the same version, after the due date was moved.
  record.set_handed_in("alice", {"", "files", false});
  record.set_handed_in("bob", {"", "files", true});
  EXPECT_FALSE(record.find_decided("alice")->late.marked);
  EXPECT_TRUE(record.find_decided("bob")->late.marked);
}

TEST_F(HandedInVersions, OfAGroupHaveThePeopleOfTheirTime) {
  const auto pair = [](const std::vector<std::string>& ids) {
    Owner owner{.name = "pair", .group = true};
    for (const std::string& id : ids) owner.members.push_back({.name = "M" + id, .id = id});
    return std::vector<HandIn>{{"pair", owner, "gradescope"}};
  };
  const Roster roster(parse_csv("id,name\n1,M1\n2,M2\n3,M3\n", "r.csv"));
  Record first(dir_, "week 1"), second(dir_, "week 2");
  first.put_people(pair({"1", "2"}), roster.people());
  first.put(graded("pair"));
  second.put_people(pair({"1", "3"}));
  second.put(graded("pair"));
  const auto absent = [](std::optional<ClassList> list) {
    std::string names;
    for (const Person* person : list->absent()) names += person->name;
    return names;
  };
  EXPECT_EQ(absent(first.class_list()), "M3");
  EXPECT_EQ(absent(second.class_list()), "M2");
  EXPECT_EQ(absent(second.class_list(Record::Of::course)), "");
  EXPECT_EQ(first.hand_ins()[0].owner.members[1].id, "2");
  EXPECT_EQ(first.hand_ins(Record::Of::course).at(0).owner.members[1].id, "3") << "the latest";
  EXPECT_EQ(first.names_for_people().at("pair"), "pair (M1; M2)");
  EXPECT_EQ(second.names_for_people().at("pair"), "pair (M1; M3)");
}

}  // namespace
}  // namespace grader::record
