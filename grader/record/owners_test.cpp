// STAFF ONLY. A record knows whose its hand-ins are and who is missing, and forgets both.
#include "grader/record/owners.h"

#include <gtest/gtest.h>

#include "grader/record/record.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"

namespace grader {
namespace {

TEST(OwnersInTheRecord, ComeBackAndMakeTheClass) {
  const hair::TemporaryFolder folder("owners");
  const Owner team{.name = "Teäm",
                   .id = "7",
                   .email = "",
                   .group = true,
                   .members = {{"A", "1", "a@u.de"}, {"B", "2", ""}}};
  const std::vector<HandIn> hand_ins{
      {"doe", {.name = "", .id = "x", .email = "", .anonymous = true}, "canvas"}, {"team", team, "moodle"}};
  const Roster roster(parse_csv("id,name,email,section\n1,A,a@u.de,x\n3,Zoë,,y\n", "r.csv"));
  {
    Record record(folder.path());
    EXPECT_FALSE(recorded_class_list(folder.path()));
    record_people(folder.path(), hand_ins, roster.people());
    EXPECT_TRUE(recorded_hand_ins(folder.path()).empty());  // nothing is graded
    for (const HandIn& one : hand_ins) {
      Recorded graded;
      graded.result.name = one.name;
      record.put(graded);
    }
  }
  record_people(folder.path(), {hand_ins[1]});  // the others stay
  const std::vector<HandIn> found = recorded_hand_ins(folder.path());
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].owner.id, "x");
  EXPECT_TRUE(found[0].owner.anonymous);
  EXPECT_EQ(found[1].system, "moodle");
  EXPECT_EQ(found[1].owner.name, "Teäm");
  ASSERT_EQ(found[1].owner.members.size(), 2u);
  EXPECT_EQ(found[1].owner.members[0].email, "a@u.de");

  const std::optional<ClassList> list = recorded_class_list(folder.path());
  ASSERT_TRUE(list && list->rows.size() == 2);
  EXPECT_EQ(list->rows[0].hand_ins, std::vector<std::string>{"team"});
  ASSERT_EQ(list->absent().size(), 1u);
  EXPECT_EQ(list->absent()[0]->name, "Zoë");
  EXPECT_EQ(list->absent()[0]->section, "y");
  EXPECT_EQ(list->strangers.size(), 2u);

  Record record(folder.path());
  record.forget("team");
  record.shred();
  EXPECT_EQ(recorded_class_list(folder.path())->rows.size(), 1u);
  for (const auto& file : std::filesystem::directory_iterator(folder.path()))
    EXPECT_EQ(hair::bytes_of(file.path()).find("a@u.de"), std::string::npos) << file.path();
}

}  // namespace
}  // namespace grader
