// STAFF ONLY. Tests that each gate lets a clean handout pass and stops a planted leak, and lists of files
// that ship.
#include "grader/package/gates.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "grader/course/input.h"
#include "grader/package/manifest.h"
#include "hair/io/files/read_file.h"
#include "solver/test_refusal.h"

namespace grader::inline package {
namespace {

using tests::says;

namespace fs = std::filesystem;

const std::string solution =
    "// the solution\n"
    "#include <vector>\n"
    "double f(double x) {\n"
    "  const double y = 2 * x;\n"
    "\n"
    "  return y * y;\n"
    "}\n";

TEST(ListingGate, OpensForWhatIsListedAlone) {
  const auto said = [](const Files& files, const Paths& listed) {
    return tests::refusal<HandoutError>([&] { check_listing(files, listed); });
  };
  EXPECT_EQ(said({{"a", ""}, {"b/c", ""}}, {"a", "b/c"}), "");
  EXPECT_EQ(said({{"a", ""}, {"secret", ""}}, {"a"}),
            "the archive holds secret, which the manifest does not list");
  EXPECT_EQ(said({{"a", ""}}, {"a", "b"}), "the archive lacks b, which the manifest lists");
}

TEST(AcceptedGate, OpensForTheListAndSaysWhatIsNewOrGone) {
  const auto said = [](const Paths& accepted) {
    return tests::refusal<HandoutError>([&] { check_accepted({"a", "b"}, accepted); });
  };
  EXPECT_EQ(said({"a", "b"}), "");
  EXPECT_TRUE(says(said({"a", "c"}), "\nb is new\nc is gone\n"));
}

TEST(CanaryGate, ClosesForAFileOfTheStaffsUnlessItIsSolved) {
  Files handout = {{"README.md", "Welcome"}, {"student/f.cpp", "// STAFF ONLY. f\n"}};
  const auto said = [&](const Paths& solved) {
    return tests::refusal<HandoutError>([&] { check_canary(handout, solved); });
  };
  EXPECT_TRUE(says(said({}), "student/f.cpp"));
  EXPECT_EQ(said({"student/f.cpp"}), "");
  handout["notes/f.cpp"] = handout["student/f.cpp"];
  EXPECT_TRUE(says(said({"student/f.cpp"}), "notes/f.cpp"));
}

// Returns the gate's complaint about a file with this text; empty: the gate is open.
std::string complaint_of(const std::string& text, const std::string& reference = solution,
                         const Paths& solved = {}) {
  return tests::refusal<HandoutError>([&] {
    check_reference_lines({{"text.md", text}}, {{"f.cpp", reference}}, solved);
  });
}

TEST(ReferenceLinesGate, ClosesForFourLinesInAnyDress) {
  const std::string lines[] = {"double f(double x) {", "const double y = 2 * x;", "return y * y;", "}"};
  const auto dressed = [&](const std::string& before, const std::string& after) {
    std::string text;
    for (const std::string& line : lines) text += before + line + after;
    return text;
  };
  const std::string dresses[] = {
      dressed("// ", "\n"), dressed(" * ", "\n"),     dressed("> // ", "\r\n"),  dressed("", " // so\n"),
      dressed("", " "),     dressed("\"", "\\n\"\n"), dressed("&lt;", "&gt;\n"), dressed("", "\n\n// and\n")};
  for (const std::string& leak : dresses)
    for (const std::string& secret : {solution, std::string("// f\n") + dressed("", "  // why\n")})
      EXPECT_TRUE(says(complaint_of(leak, secret), "text.md:1")) << leak;
}

TEST(ReferenceLinesGate, ClosesAndOpens) {
  const std::string names = "double f(double x) {\nusing std::abs;\nreturn 2 * abs(x) +\nx / 17.25;\n}\n",
                    includes =
                        "#include <cmath>\n#include <limits>\n\n  #include <string>\n#include <vector>\n";
  const auto itself = [](const std::string& text) { return std::pair(text, text); };
  const struct {
    const char* what;
    std::pair<std::string, std::string> text;  // and the reference
    bool closes;
    Paths solved = {};
  } rows[] = {
      {"past using",
       {"// double f(double x) {\n// using std::abs;\n// return 2 * abs(x) +\n// x / 17.25;\n// }\n", names},
       true},
      {"past namespace",
       {"namespace hair { double f(double x) { return 2 * abs(x) + x / 17.25; } }", names},
       true},
      // A secret needs three lines with letters, 30 in all.
      {"29 letters", itself("one_of_ten\nten_of_ten\n}\nnineteen9\n"), false},
      {"30 letters", itself("one_of_ten\nten_of_ten\n}\nnineteen10\n"), true},
      {"two lines with letters", itself("(one_of_ten\n{\n}\nlong_enough_to_be_a_secret_of_its_own)\n"),
       false},
      {"five lines, 29 letters", itself("a;\nb;\nc;\n}\nlast_of_twenty_six_letters\n"), false},
      {"five lines, 30 letters", itself("a;\nb;\nc;\n}\nlast_of_twenty_seven_letter\n"), true},
      {"three lines", {"  const double y = 2 * x;\n  return y * y;\n}\n", solution}, false},
      {"includes alone", {includes, includes + solution}, false},
      {"includes and more", {includes + solution, includes + solution}, true},
      {"a stub",
       {"double f(double) {\n  throw NotImplemented(\"f\");\n}\n/*\n" + solution + "*/\n", solution},
       true},
      {"a solved file", itself(solution), false, {"text.md"}},
      {"another file than the solved one", itself(solution), true, {"other.md"}},
  };
  for (const auto& [what, text, closes, solved] : rows)
    EXPECT_EQ(complaint_of(text.first, text.second, solved) != "", closes) << what;
}

// The canary guards only files that carry it.
TEST(Canary, StandsInEveryFileOfTheStaffs) {
  namespace fs = std::filesystem;
  // JSON and pictures have no comments.
  const std::set<fs::path> without_comments = {".json", ".png"};
  for (const std::string folder : {"reference", "grader"})
    for (const fs::directory_entry& entry :
         fs::recursive_directory_iterator(fs::path(HAIR_SOURCE_DIR) / folder)) {
      if (!entry.is_regular_file() || without_comments.contains(entry.path().extension())) continue;
      EXPECT_TRUE(carries_canary(hair::bytes_of(entry.path())))
          << entry.path() << " must say STAFF ONLY in one of its first three lines";
    }
}

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

// These are the files of S1.
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
