// STAFF ONLY.

#include "grader/package/manifest.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "grader/course/input.h"

namespace grader {
namespace {

Course course_with(Role role) {
  Exercise exercise;
  exercise.id = "S1";
  exercise.role = role;
  return {{{exercise}}};
}

std::vector<ManifestLine> read(const std::string& text, Role role = Role::assigned) {
  const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
  const std::filesystem::path file = std::filesystem::path(HAIR_SCRATCH_DIR) / (name + "_manifest.txt");
  std::ofstream(file) << text;
  const Course course = course_with(role);
  return read_manifest(file, course);
}

std::string complaint(const std::string& text) {
  try {
    read(text);
    return "";
  } catch (const BadInput& error) {
    return error.what();
  }
}

TEST(Manifest, ShipsAFileOfTheHandoutAtItsTopAndOthersWhereTheyAre) {
  const auto lines =
      read("# comment\n\nhandout/README.md\nsolver/a.h\n golden/x.mtx  ->  checks/golden/x.mtx \n");
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0].destination, "README.md");
  EXPECT_EQ(lines[1].destination, "solver/a.h");
  EXPECT_EQ(lines[2].source, "golden/x.mtx");
  EXPECT_EQ(lines[2].destination, "checks/golden/x.mtx");
}

TEST(Manifest, LeavesOutTheLinesOfAbsentExercises) {
  const std::string text = "handout/README.md\nS1: handout/student/f.cpp\n";
  for (Role role : {Role::assigned, Role::optional, Role::given}) EXPECT_EQ(read(text, role).size(), 2u);
  EXPECT_EQ(read(text, Role::absent).size(), 1u);
  EXPECT_EQ(read("S1, S1: hair/scenes/a.json\n", Role::absent).size(), 0u);
}

TEST(Manifest, NamesFileAndLineOfWhatIsWrong) {
  EXPECT_NE(complaint("a\nS7: b\n").find("manifest.txt:2: there is no exercise \"S7\""), std::string::npos);
  EXPECT_NE(complaint("../secret\n").find("manifest.txt:1: \"../secret\" is no path"), std::string::npos);
  EXPECT_NE(complaint("/etc/passwd\n").find("is no path"), std::string::npos);
  EXPECT_NE(complaint("a -> ../b\n").find("is no path"), std::string::npos);
  EXPECT_NE(complaint("a ->\n").find("is no path"), std::string::npos);
  EXPECT_NE(complaint("a/../b\n").find("is no path"), std::string::npos);
  EXPECT_NE(complaint("handout/a\nb -> a\n").find("manifest.txt:2: a is already the destination of"),
            std::string::npos);
}

}  // namespace
}  // namespace grader
