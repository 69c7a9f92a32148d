// STAFF ONLY. Tests that names are safe for files, pages and command lines, and stay apart.
#include "grader/intake/names/names.h"

#include <gtest/gtest.h>

namespace grader::inline intake {
namespace {

TEST(SubmissionName, IsSafeForFilesAndPages) {
  EXPECT_EQ(submission_name("Smith, Zoë <b>.zip"), "Smith__Zo____b_");
  EXPECT_EQ(submission_name("staff.zip"), "staff_");
  EXPECT_EQ(submission_name("grades.csv.zip"), "grades.csv_");
  EXPECT_EQ(submission_name("alice.v2.ZIP"), "alice.v2");
  EXPECT_EQ(submission_name("bob.pdf"), "bob");
  EXPECT_LE(submission_name(std::string(200, 'x') + ".zip").size(), 150u);
}

// Then no program takes a name for an option, and no folder hides it.
TEST(SubmissionName, BeginsWithALetterOrADigit) {
  EXPECT_EQ(submission_name("-rf.zip"), "x-rf");
  EXPECT_EQ(submission_name("--out"), "x--out");
  EXPECT_EQ(submission_name("_alice"), "x_alice");
  EXPECT_EQ(submission_name(".hidden.zip"), "x.hidden");
  EXPECT_EQ(submission_name("..zip"), "x.");
  EXPECT_EQ(submission_name("=cmd.zip"), "x_cmd");
  EXPECT_EQ(submission_name(".zip"), "x");
  EXPECT_EQ(submission_name("Ärger.zip"), "x__rger");
  EXPECT_EQ(submission_name("7of9.zip"), "7of9");
  for (int byte = 1; byte < 256; ++byte) {
    const std::string name = submission_name(std::string(1, static_cast<char>(byte)) + "name");
    EXPECT_TRUE(std::isalnum(static_cast<unsigned char>(name.front()))) << byte << ": " << name;
  }
}

TEST(SubmissionName, AmongEqualsDependsOnThePathAlone) {
  const std::string name = name_among_equals("x_1", "/class/x 1");
  EXPECT_TRUE(name.starts_with("x_1-")) << name;
  EXPECT_EQ(name, name_among_equals("x_1", "/class/x 1"));
  EXPECT_NE(name, name_among_equals("x_1", "/class/x_1"));
  EXPECT_EQ(name, submission_name(name)) << "it is a safe name";
}

TEST(NameOfAnOwner, HasItsIdWhole) {
  EXPECT_EQ(name_of_owner({.name = "doejane", .id = "4711"}), "doejane_4711");
  EXPECT_EQ(name_of_owner({.name = "Jörg Müller", .id = "4711"}), "Jorg_Muller_4711");
  EXPECT_EQ(name_of_owner({.name = "王伟", .id = "4711"}), "4711");
  EXPECT_EQ(name_of_owner({.id = "so12"}), "so12");
  EXPECT_EQ(name_of_owner({.id = "aB3dE", .anonymous = true}), "anon_aB3dE");
  EXPECT_TRUE(name_of_owner({.name = std::string(300, 'x'), .id = "4711"}).ends_with("x_4711"));
}

TEST(NameOfAnOwner, TellsNamesWithoutAsciiApart) {
  const std::string one = name_of_owner({.name = "王伟"}), other = name_of_owner({.name = "李娜"});
  EXPECT_NE(one, other);
  EXPECT_EQ(one, submission_name(one)) << "it is a safe name";
}

}  // namespace
}  // namespace grader::intake
