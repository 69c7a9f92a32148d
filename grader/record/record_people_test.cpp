// STAFF ONLY. Tests that a record knows the owners of hand-ins and missing people, and forgets both.
#include "grader/record/record.h"

#include <gtest/gtest.h>

#include "grader/course/input.h"
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

}  // namespace
}  // namespace grader::record
