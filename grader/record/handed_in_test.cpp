// STAFF ONLY. Tests the record of a version that was handed in: its time, the learning system's mark, and its
// owner.
#include <gtest/gtest.h>

#include "grader/record/record.h"
#include "hair/io/files/temporary_folder.h"

namespace grader::inline record {
namespace {

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
