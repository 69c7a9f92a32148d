// STAFF ONLY. Tests right and broken lists of files that ship.

#include "grader/package/manifest.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "grader/course/input.h"
#include "solver/test_refusal.h"

namespace grader::inline package {
namespace {

namespace fs = std::filesystem;
using tests::says;

std::set<std::string> destinations(const std::vector<ManifestLine>& lines) {
  std::set<std::string> found;
  for (const ManifestLine& line : lines) found.insert(line.destination);
  return found;
}

Course course_with(Role role) {
  Exercise exercise;
  exercise.id = "S1";
  exercise.file = "s.cpp";
  exercise.folder = "exercises/S1";
  exercise.header = "solver/s.h";
  exercise.role = role;
  return {{{exercise}}};
}

std::vector<ManifestLine> read(const std::string& text, Role role = Role::assigned) {
  const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
  const fs::path root = fs::path(HAIR_SCRATCH_DIR) / ("Manifest" + name);
  fs::create_directories(root / "handout");
  fs::create_directories(root / "solver/lib/more");
  for (const char* file : {"solver/lib/a.cpp", "solver/lib/a.h", "solver/lib/more/b.cpp",
                           "solver/lib/a_test.cpp", "solver/lib/test_a.h", "solver/lib/tests.cmake"})
    std::ofstream(root / file) << "//\n";
  fs::create_directories(root / "handout/exercises/S1");
  for (const char* file : {"text.md", "check.cpp", "s.cpp"})
    std::ofstream(root / "handout/exercises/S1" / file) << "//\n";
  std::ofstream(root / "handout/manifest.txt") << text;
  return read_manifest(root, course_with(role));
}

std::string complaint(const std::string& text) {
  return tests::refusal<BadInput>([&] { read(text); });
}

using Destinations = std::set<std::string>;

// Are the files of S1.
const Destinations kExercise = {"exercises/S1/text.md", "exercises/S1/check.cpp", "solver/s.h",
                                "stubs/s.cpp.stub"};

TEST(Manifest, PutsTheHandoutOnTopAndGivenCodeBelowGiven) {
  const auto lines = read(
      "# comment\n\nhandout/README.md\nsolver/a.h\nsolver/b.h -> solver/b.h\n golden/x.mtx  ->  "
      "check/golden/x.mtx \n");
  Destinations expected = kExercise;
  expected.insert({"README.md", "given/solver/a.h", "solver/b.h", "check/golden/x.mtx"});
  EXPECT_EQ(destinations(lines), expected);
  EXPECT_EQ(lines.back().source, "golden/x.mtx");
}

TEST(Manifest, TakesTheFilesOfAFolderAndNeitherItsTestsNorItsFolders) {
  Destinations expected = kExercise;
  expected.insert({"given/solver/lib/a.cpp", "given/solver/lib/a.h"});
  EXPECT_EQ(destinations(read("solver/lib/\n")), expected);
  expected = kExercise;
  expected.insert({"top/a.cpp", "top/a.h"});
  EXPECT_EQ(destinations(read("S1: solver/lib/ -> top/\n")), expected);
}

TEST(Manifest, LeavesOutWhatIsOfAbsentExercisesButTheirContracts) {
  const std::string text = "handout/README.md\nS1: handout/figure.svg\nS1: solver/lib/\n";
  for (Role role : {Role::assigned, Role::optional, Role::given}) EXPECT_EQ(read(text, role).size(), 8u);
  EXPECT_EQ(destinations(read(text, Role::absent)), (Destinations{"README.md", "solver/s.h"}));
  EXPECT_EQ(read("S1, S1: hair/scenes/a.json\n", Role::absent).size(), 1u);
}

TEST(Manifest, NamesFileAndLineOfWhatIsWrong) {
  EXPECT_TRUE(says(complaint("a\nS7: b\n"), "manifest.txt:2: there is no exercise \"S7\""));
  EXPECT_TRUE(says(complaint("../secret\n"), "manifest.txt:1: \"../secret\" is no path"));
  EXPECT_TRUE(says(complaint("/etc/passwd\n"), "is no path"));
  EXPECT_TRUE(says(complaint("a -> ../b\n"), "is no path"));
  EXPECT_TRUE(says(complaint("a ->\n"), "is no path"));
  EXPECT_TRUE(says(complaint("a/../b\n"), "is no path"));
  EXPECT_TRUE(
      says(complaint("solver/nothing/\n"), "manifest.txt:1: solver/nothing/ is no folder with files"));
  EXPECT_TRUE(says(complaint("solver/lib/ -> a\n"), "manifest.txt:1: a folder's source and destination"));
  EXPECT_TRUE(says(complaint("a\nsolver/s.h -> solver/s.h\n"),
                   "manifest.txt:2: solver/s.h is already the destination of exercises.json: S1"));
  EXPECT_TRUE(says(complaint("handout/a\nb -> a\n"), "manifest.txt:2: a is already the destination of"));
}

}  // namespace
}  // namespace grader::package
