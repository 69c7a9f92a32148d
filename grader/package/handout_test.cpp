// STAFF ONLY. Tests handouts of a small project of two exercises, with planted leaks.

#include "grader/package/handout.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>

#include "grader/course/input.h"
#include "grader/package/course_texts.h"
#include "grader/package/pages.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/start_program.h"
#include "solver/test_refusal.h"

namespace grader::inline package {
namespace {

namespace fs = std::filesystem;
using tests::says;

const std::string kSolved =
    "// STAFF ONLY. f\nint f() {\n  int one = 1;\n  int two = 2;\n  int three = 3;\n  return one + two + "
    "three;\n}\n";

class SmallProject : public testing::Test {
 protected:
  SmallProject() {
    fs::remove_all(root_);
    write("handout/manifest.txt",
          "handout/README.md\nhandout/exercises.json\nhandout/assignment/README.md\n"
          "E2: golden/g.mtx -> check/golden/g.mtx\nhair/scenes/\n"
          "golden/scenes.md -> given/hair/scenes/scenes.md\n");
    write("grader/package/pages.js", "console.log('a library is missing'); process.exit(77)");
    write("handout/README.md", "Welcome\n");
    write("handout/exercises.json",
          R"({"exercises": [{"id": "E1", "file": "f.cpp", "points": 1, "role": "assigned"},
                                                      {"id": "E2", "file": "g.cpp", "points": 1, "role": "assigned"}]})");
    write("handout/assignment/README.md",
          "# Exercises\n" + std::string(kExerciseRows) + "\n| id |\n| E7 |\nGood luck\n");
    write("hair/scenes/one.json", "{}\n");
    write("hair/scenes/two.json", "{}\n");
    write("build/golden/motions/one.json", "{}\n");
    write("build/golden/motions/two.json", "{}\n");
    write("build/golden/scenes.md", "| [one](one.json) | E1 | x |\n| [two](two.json) | E1, E2 | x |\n");
    for (const std::string id : {"E1", "E2"}) {
      write("handout/exercises/" + id + "/text.md",
            "# " + id +
                "\n\n<!-- categories -->\n<!-- mistakes -->\n[contract](../../../hair/scenes/one.json)\n");
      write(
          "handout/exercises/" + id + "/categories.json",
          R"([{"id": "A", "title": "All", "points": 2, "asks": "it", "rows": [{"id": "r", "see": "NaN", "look": "Is it 0?", "usual": true},
              {"id": "s", "see": "no", "look": "no"}]}, {"id": "B", "title": "Rest", "points": 3, "asks": "$x$"}])");
    }
    write("handout/exercises/E1/f.cpp", "int f();\n");
    write("handout/exercises/E2/g.cpp", "int g();\n");
    write("reference/E1/f.cpp", kSolved);
    write("reference/E2/g.cpp", "// STAFF ONLY. g\nint g() { return 1; }\n");
    write("build/golden/g.mtx", "1 1 1\n");
    for (const std::string id : {"E1", "E2"}) {
      Exercise exercise;
      exercise.id = id;
      exercise.title = "Exercise " + id;
      exercise.file = id == "E1" ? "f.cpp" : "g.cpp";
      exercise.folder = "exercises/" + id;
      exercise.points = 7.5;
      course_.exercises.push_back(exercise);
    }
    accept();
  }

  void accept() { accept_files(sources_, course_); }

  // Appends a line to the manifest.
  void list(const std::string& line) {
    std::ofstream(root_ / "handout/manifest.txt", std::ios::app) << line << "\n";
  }

  void write(const std::string& path, const std::string& text) {
    fs::create_directories((root_ / path).parent_path());
    std::ofstream(root_ / path) << text;
  }

  Files files() const { return handout_files(sources_, course_); }

  // Returns the message of make_handout, which must leave nothing behind then.
  std::string complaint() {
    try {
      make_handout(sources_, course_, out_);
      return "";
    } catch (const HandoutError& error) {
      EXPECT_FALSE(fs::exists(out_) || fs::exists(out_.string() + ".part"));
      return error.what();
    }
  }

  fs::path root_ = fs::path(HAIR_SCRATCH_DIR) / testing::UnitTest::GetInstance()->current_test_info()->name();
  fs::path out_ = root_ / "handout.tar.gz";
  HandoutSources sources_{root_, root_ / "build/golden"};
  Course course_;
};

// Checks pages of the site; packs nothing.
TEST_F(SmallProject, PagesForEverybodyHoldNoSolutionAndNothingOfTheStaffs) {
  const auto check = [&](const std::string& page) { check_pages({{"a/b.html", page}}, sources_, course_); };
  check("<pre>int f();</pre>");
  EXPECT_THROW(check("<!-- STAFF ONLY. -->"), HandoutError);
  EXPECT_THROW(check("<pre>" + kSolved.substr(kSolved.find('\n')) + "</pre>"), HandoutError);
}

TEST_F(SmallProject, ShipsStubsOfAssignedAndOptionalExercises) {
  course_.exercises[1].role = Role::optional;
  const Files shipped = files();
  EXPECT_EQ(shipped.at("stubs/f.cpp.stub"), "int f();\n");
  EXPECT_EQ(shipped.at("stubs/g.cpp.stub"), "int g();\n");
  EXPECT_EQ(shipped.at("check/golden/g.mtx"), "1 1 1\n");
}

TEST_F(SmallProject, ShipsAGivenExerciseSolvedAndPassesItsGates) {
  course_.exercises[0].role = Role::given;
  EXPECT_EQ(files().at("stubs/f.cpp.stub"), kSolved);
  EXPECT_EQ(complaint(), "");
}

TEST_F(SmallProject, LeavesOutAllButTheListsEntryOfAnAbsentExercise) {
  course_.exercises[1].role = Role::absent;
  const Files shipped = files();
  EXPECT_FALSE(shipped.contains("stubs/g.cpp.stub") || shipped.contains("check/golden/g.mtx"));
  for (const auto& [path, text] : shipped)
    EXPECT_TRUE(path == "exercises.json" || text.find("E2") == std::string::npos) << path;
  EXPECT_EQ(nlohmann::json::parse(shipped.at("exercises.json"))["exercises"][1]["role"], "absent");
  EXPECT_EQ(shipped.at("given/hair/scenes/scenes.md"), "| [one](one.json) | E1 | x |\n");
  EXPECT_TRUE(shipped.contains("given/hair/scenes/one.json"));
  EXPECT_FALSE(shipped.contains("given/hair/scenes/two.json"));
  EXPECT_TRUE(shipped.contains("given/hair/motions/one.json"));
  EXPECT_FALSE(shipped.contains("given/hair/motions/two.json"));
}

TEST_F(SmallProject, ShipsTheCoursesRolesAndPoints) {
  course_.exercises[1].role = Role::optional;
  course_.exercises[1].points = 3;
  const Files shipped = files();
  const auto json = nlohmann::json::parse(shipped.at("exercises.json"));
  EXPECT_EQ(json["exercises"][0]["points"], 7.5);
  EXPECT_EQ(json["exercises"][1]["points"], 3);
  EXPECT_EQ(json["exercises"][1]["role"], "optional");
  EXPECT_EQ(
      shipped.at("assignment/README.md"),
      "# Exercises\n| id | text | you write | needs | points |\n|---|---|---|---|---|\n"
      "| E1 | [Exercise E1](../exercises/E1/text.md) | `student/f.cpp` | - | 7.5 |\n"
      "| E2 | [Exercise E2](../exercises/E2/text.md) | `student/g.cpp` | - | 3, extra credit |\nGood luck\n");
  EXPECT_TRUE(shipped.contains("given/hair/scenes/two.json"));
}

TEST_F(SmallProject, FillsInATextsPointsAndLinks) {
  EXPECT_EQ(files().at("exercises/E1/text.md"),
            "# E1\n\n7.5 points, in these categories:\n\n| category | points | asks for |\n|---|---|---|\n"
            "| All | 3 | it |\n| Rest | 4.5 | $x$ |\n- *All: NaN.* Is it "
            "0?\n[contract](../../given/hair/scenes/one.json)\n");
  course_.exercises[0].role = Role::given;
  EXPECT_TRUE(says(files().at("exercises/E1/text.md"), "| All | - | it |"));
  EXPECT_EQ(nlohmann::json::parse(files().at("exercises/E2/categories.json"))[0]["points"], 3);
}

TEST_F(SmallProject, ShipsAPageOfEachTextOrSaysWhyNot) {
  const std::string path = std::getenv("PATH"),
                    makes =
                        "cd $2; shift 2; echo free > assignment/font-licence.txt; "
                        "for text; do sed 's/^/page of /' $text > ${text%md}html; done; ";
  setenv("PATH", (root_.string() + "/bin:" + path).c_str(), 1);
  const auto with_node = [&](const std::string& script) {
    write("bin/node", "#!/bin/sh\n" + script);
    fs::permissions(root_ / "bin/node", fs::perms::owner_all);
    fs::remove(out_);
  };
  with_node(makes);
  Files shipped = files();
  EXPECT_EQ(add_pages(shipped, ""), "");
  EXPECT_TRUE(shipped.at("README.md").starts_with("**[Open README.html in a browser](README.html)**"));
  EXPECT_EQ(shipped.at("README.html"), "page of Welcome\n");
  EXPECT_EQ(make_handout(sources_, course_, out_), "");
  with_node("echo katex is missing; exit 77");
  EXPECT_TRUE(says(make_handout(sources_, course_, out_), "have no pages: katex is missing; install"));
  with_node(makes + "echo STAFF ONLY >> README.html");
  EXPECT_TRUE(says(complaint(), "README.html says STAFF ONLY"));
  for (const auto& [script, why] :
       {std::pair<std::string, std::string>{"echo bad formula; exit 1", "bad formula"},
        {makes + "rm */E2/text.html", "did not write exercises/E2/text.html"}}) {
    with_node(script);
    EXPECT_TRUE(says(tests::refusal<BadInput>([&] { make_handout(sources_, course_, out_); }), why));
  }
  setenv("PATH", path.c_str(), 1);
}

TEST_F(SmallProject, ShipsTwoRunsAsAPageThatPlaysThem) {
  write("handout/exercises/E1/view.json", R"([{"a":1},{"b":2}])");
  const Files shipped = files();
  EXPECT_FALSE(shipped.contains("exercises/E1/view.json"));
  for (const char* run : {R"(data-name="right">{"a":1}</script>)", R"(data-name="wrong">{"b":2})"})
    EXPECT_TRUE(says(shipped.at("exercises/E1/view.html"), run));
}

TEST_F(SmallProject, GivesTheSameBytesAgain) {
  make_handout(sources_, course_, out_);
  make_handout(sources_, course_, root_ / "again.tar.gz");
  EXPECT_EQ(hair::bytes_of(out_), hair::bytes_of(root_ / "again.tar.gz"));
}

TEST_F(SmallProject, DatesFilesByTheNewestCommitThatIsNotToCome) {
  const auto run = [&](std::vector<std::string> words, const std::string& date = "") {
    words.insert(words.begin(), "/usr/bin/env");
    return hair::exit_code_of(hair::start_program({.words = std::move(words),
                                                   .output = "/dev/null",
                                                   .folder = root_,
                                                   .environment = {"GIT_COMMITTER_DATE=" + date}}));
  };
  const auto date_of_files = [&] {
    make_handout(sources_, course_, out_);
    EXPECT_EQ(run({"tar", "xzf", out_.string()}), 0);
    struct stat file = {};
    EXPECT_EQ(stat((root_ / "hair-assignment/README.md").c_str(), &file), 0);
    return file.st_mtime;
  };
  EXPECT_EQ(date_of_files(), 946684800) << "without a commit";
  ASSERT_EQ(run({"git", "init", "-q"}), 0);
  for (const auto& [date, expected] : {std::pair{1600000000L, 1600000000L}, {4000000000L, 946684800L}}) {
    write("handout/README.md", std::to_string(date) + "\n");
    ASSERT_EQ(run({"git", "add", "handout"}), 0);
    ASSERT_EQ(run({"git", "-c", "user.name=a", "-c", "user.email=a@b", "commit", "-qm", "all"},
                  "@" + std::to_string(date) + " +0000"),
              0);
    EXPECT_EQ(date_of_files(), expected);
  }
}

TEST_F(SmallProject, ClosesForAStaffFileInTheManifest) {
  list("reference/E2/g.cpp -> check/example.cpp");
  accept();
  EXPECT_TRUE(says(complaint(), "check/example.cpp says STAFF ONLY"));
}

TEST_F(SmallProject, ClosesForReferenceLinesInAText) {
  std::ofstream(root_ / "handout/README.md", std::ios::app) << kSolved.substr(kSolved.find('\n'));
  EXPECT_TRUE(says(complaint(), "README.md:3: what it says stands in reference/E1/f.cpp:2"));
}

TEST_F(SmallProject, LeavesTheOldArchiveWhenAGateCloses) {
  make_handout(sources_, course_, out_);
  const std::string before = hair::bytes_of(out_);
  write("handout/README.md", "STAFF ONLY\n");
  EXPECT_THROW(make_handout(sources_, course_, out_), HandoutError);
  EXPECT_EQ(hair::bytes_of(out_), before);
}

TEST_F(SmallProject, ClosesForAFolderThatHoldsATestOfAnotherNameABenchmarkOrAStaffFile) {
  write("solver/lib/a.h", "int a();\n");
  list("solver/lib/");
  accept();
  EXPECT_EQ(complaint(), "");
  EXPECT_EQ(files().at("given/solver/lib/a.h"), "int a();\n");
  fs::remove(out_);
  for (const auto& [name, text, kind] :
       {std::array<std::string, 3>{"looks_good.cpp", "#include <gtest/gtest.h>\n", "of a test"},
        {"a_bench.cpp", "int main() {}\n", "of a benchmark"},
        {"speed.cpp", "#include <benchmark/benchmark.h>\n", "of a benchmark"},
        {"a_fuzz.cpp", "int main() {}\n", "of a fuzz program"},
        {"any_bytes.cpp", "extern \"C\" int LLVMFuzzerTestOneInput();\n", "of a fuzz program"},
        {"notes.md", "# Notes\n\nSTAFF ONLY\n", "a staff file"}}) {
    write("solver/lib/" + name, text);
    EXPECT_TRUE(says(complaint(), "manifest.txt:7: solver/lib/" + name + " is " + kind));
    EXPECT_THROW(accept(), HandoutError) << name;
    fs::remove(root_ / "solver/lib" / name);
  }
  EXPECT_EQ(complaint(), "");
}

TEST_F(SmallProject, ClosesForFilesThatAreNewOrGoneUntilTheyAreAccepted) {
  write("solver/lib/a.h", "int a();\n");
  write("solver/lib/b.h", "int b();\n");
  list("solver/lib/");
  accept();
  fs::rename(root_ / "solver/lib/b.h", root_ / "solver/lib/c.h");
  write("solver/lib/d.h", "int d();\n");
  EXPECT_EQ(complaint(),
            "the handout is not the one of handout/packed.txt:\ngiven/solver/lib/c.h is "
            "new\ngiven/solver/lib/d.h is new\n"
            "given/solver/lib/b.h is gone\nLook at each file; then \"hairgrade handout --accept --out "
            "FILE.tar.gz\" writes the "
            "list anew");
  accept();
  EXPECT_EQ(complaint(), "");
}

// The list is the whole course's.
TEST_F(SmallProject, AcceptsForAllCourses) {
  const std::string before = hair::bytes_of(root_ / "handout/packed.txt");
  course_.exercises[1].role = Role::absent;
  EXPECT_EQ(complaint(), "");
  accept();
  EXPECT_EQ(hair::bytes_of(root_ / "handout/packed.txt"), before);
}

TEST_F(SmallProject, NamesWhatCantBeReadOrWritten) {
  EXPECT_THROW(make_handout(sources_, course_, root_), BadInput);
  EXPECT_THROW(make_handout(sources_, course_, root_ / "nowhere/handout.tar.gz"), BadInput);
  fs::remove(root_ / "build/golden/g.mtx");
  const std::string why = tests::refusal<BadInput>([&] { make_handout(sources_, course_, out_); });
  EXPECT_TRUE(says(why, "manifest.txt:4"));
  EXPECT_TRUE(says(why, "g.mtx is not made yet; start this by ./grader/grade"));
}

}  // namespace
}  // namespace grader::package
