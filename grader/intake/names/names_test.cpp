// STAFF ONLY. Tests that names are safe for files, pages and command lines, and stay apart; and that a rule
// chooses one of several files with the same name, or that it stays open.
#include "grader/intake/names/names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "grader/intake/names/exercise_names.h"
#include "grader/intake/names/same_name.h"

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

// Returns the paths of the best conj_grad.cpp, "a | b".
std::string taken(const std::vector<std::string>& paths) {
  std::vector<Candidate> all;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const auto likeness = exercise_file(paths[i].substr(paths[i].rfind('/') + 1), {"conj_grad.cpp"}).value();
    all.push_back({i, paths[i], likeness.degree == Likeness::Degree::renamed, likeness.number});
  }
  const std::size_t best = put_best_first(all);
  std::string said;
  for (std::size_t i = 0; i < best; ++i) said += (i > 0 ? " | " : "") + std::string(all[i].path);
  return said;
}

TEST(SameName, ARuleDecidesWhateverTheOrder) {
  // The first path of each case counts.
  const std::vector<std::vector<std::string>> cases = {
      {"hair/student/conj_grad.cpp", "hair/Backup/conj_grad.cpp"},
      {"hair/student/conj_grad.cpp", "hair/student/old/conj_grad.cpp", "hair/x/conj_grad.cpp"},
      {"hair/STUDENT/conj_grad.cpp", "conj_grad.cpp", "hair/student/conj_grad (1).cpp"},
      {"conj_grad.cpp", "build/conj_grad.cpp", "cmake-build-debug/conj_grad.cpp", "out/conj_grad.cpp",
       "bin/student/conj_grad.cpp", "build2/conj_grad.cpp"},
      {"hw/conj_grad.cpp", "hw.bak/conj_grad.cpp", "old hw/conj_grad.cpp", "Copy of hw/conj_grad.cpp",
       "hw - Copy/conj_grad.cpp", "hw_copy/conj_grad.cpp", "backups/3/conj_grad.cpp", "hw-OLD/conj_grad.cpp"},
      {"backup/new/conj_grad.cpp", "backup/new/Conj_Grad.cpp"},
      {"Version 10/conj_grad.cpp", "Version 2/conj_grad.cpp", "version 9/conj_grad.cpp"},
      {"hw_v3/src/conj_grad.cpp", "hw_v1/src/conj_grad.cpp", "hw_v2/src/conj_grad.cpp"},
      {"hw (2)/conj_grad.cpp", "hw (1)/conj_grad.cpp"},
      {"conj_grad.cpp", "conj_grad-1.cpp", "conj_grad (7).cpp", "CONJ_GRAD.CPP"},
      {"conj_grad-12.cpp", "conj_grad-1.cpp", "conj_grad-2.cpp"},
      {"Version 2/student/conj_grad.cpp", "Version 1/student/conj_grad.cpp", "Version 3/conj_grad.cpp"},
  };
  for (std::vector<std::string> paths : cases) {
    const std::string first = paths.front();
    for (std::size_t i = 0; i < paths.size(); ++i) {
      EXPECT_EQ(taken(paths), first) << testing::PrintToString(paths);
      std::rotate(paths.begin(), paths.begin() + 1, paths.end());
    }
  }
}

TEST(SameName, NothingElseDecides) {
  const std::vector<std::vector<std::string>> cases = {
      {"a/conj_grad.cpp", "b/conj_grad.cpp"},
      {"conj_grad.cpp", "Version 2/conj_grad.cpp"},
      {"conj_grad.cpp", "src/conj_grad.cpp"},
      {"hair/conj_grad.cpp", "hair (1)/conj_grad.cpp"},  // unpacked once more: the second has the stubs
      {"lab-1/conj_grad.cpp", "lab-2/conj_grad.cpp"},
      {"exercise1/conj_grad.cpp", "exercise2/conj_grad.cpp"},
      {"hw v1/conj_grad.cpp", "project v2/conj_grad.cpp"},
      {"a/student/conj_grad.cpp", "b/student/conj_grad.cpp"},
      {"student/conj_grad.cpp", "Student/conj_grad.cpp"},
      {"CONJ_GRAD.cpp", "Conj_grad.cpp"},
      {"Conj_grad.cpp", "conj_grad (1).cpp"},
      {"builder/conj_grad.cpp", "goldfish/conj_grad.cpp"},
      {"old/conj_grad.cpp", "build/conj_grad.cpp"},
  };
  for (const std::vector<std::string>& paths : cases) EXPECT_EQ(taken(paths), paths[0] + " | " + paths[1]);
}

}  // namespace
}  // namespace grader::intake
