// STAFF ONLY. Handouts of a small project of two exercises, into which leaks are planted, and of the real
// one.

#include "grader/package/handout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <regex>

#include "grader/course/input.h"
#include "grader/package/course_texts.h"
#include "grader/package/manifest.h"
#include "hair/io/files/read_file.h"

namespace grader {
namespace {

namespace fs = std::filesystem;

const std::string kSolved =
    "// STAFF ONLY. f\nint f() {\n  int one = 1;\n  int two = 2;\n  int three = 3;\n  return one + two + "
    "three;\n}\n";

class SmallProject : public testing::Test {
 protected:
  SmallProject() {
    fs::remove_all(root_);
    write("handout/manifest.txt",
          "handout/README.md\nhandout/exercises.json\nhandout/assignment/README.md\n"
          "E1: handout/assignment/E1.md\nE2: handout/assignment/E2.md\n"
          "E1: handout/student/f.cpp\nE2: handout/student/g.cpp\nE2: golden/g.mtx -> checks/golden/g.mtx\n");
    write("handout/README.md", "Welcome\n");
    write("handout/exercises.json",
          R"({"exercises": [{"id": "E1", "file": "f.cpp", "points": 1, "role": "assigned"},
                                                      {"id": "E2", "file": "g.cpp", "points": 1, "role": "assigned"}]})");
    write("handout/assignment/README.md",
          "# Exercises\n| E1 | old |\n| E2 | old |\n| `one` | E1 | x |\n| `two` | E1, E2 | x |\nGood luck\n");
    write("handout/assignment/E1.md", "# E1\n");
    write("handout/assignment/E2.md", "# E2\n");
    write("handout/student/f.cpp", "int f();\n");
    write("handout/student/g.cpp", "int g();\n");
    write("reference/f.cpp", kSolved);
    write("reference/g.cpp", "// STAFF ONLY. g\nint g() { return 1; }\n");
    write("build/golden/g.mtx", "1 1 1\n");
    for (const std::string id : {"E1", "E2"}) {
      Exercise exercise;
      exercise.id = id;
      exercise.title = "Exercise " + id;
      exercise.file = id == "E1" ? "f.cpp" : "g.cpp";
      exercise.text = "assignment/" + id + ".md";
      exercise.points = 7.5;
      course_.exercises.push_back(exercise);
    }
  }

  void write(const std::string& path, const std::string& text) {
    fs::create_directories((root_ / path).parent_path());
    std::ofstream(root_ / path) << text;
  }

  Files files() const { return handout_files(sources_, course_); }

  // What make_handout says; then it must have left nothing behind.
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

TEST_F(SmallProject, ShipsStubsOfAssignedAndOptionalExercises) {
  course_.exercises[1].role = Role::optional;
  const Files shipped = files();
  EXPECT_EQ(shipped.at("student/f.cpp"), "int f();\n");
  EXPECT_EQ(shipped.at("student/g.cpp"), "int g();\n");
  EXPECT_EQ(shipped.at("checks/golden/g.mtx"), "1 1 1\n");
}

TEST_F(SmallProject, ShipsAGivenExerciseSolvedAndPassesItsGates) {
  course_.exercises[0].role = Role::given;
  EXPECT_EQ(files().at("student/f.cpp"), kSolved);
  EXPECT_EQ(complaint(), "");
}

TEST_F(SmallProject, LeavesOutAllButTheListsEntryOfAnAbsentExercise) {
  course_.exercises[1].role = Role::absent;
  const Files shipped = files();
  EXPECT_FALSE(shipped.contains("student/g.cpp") || shipped.contains("checks/golden/g.mtx"));
  for (const auto& [path, text] : shipped)
    EXPECT_TRUE(path == "exercises.json" || text.find("E2") == std::string::npos) << path;
  EXPECT_EQ(nlohmann::json::parse(shipped.at("exercises.json"))["exercises"][1]["role"], "absent");
  EXPECT_NE(shipped.at("assignment/README.md").find("| `one` |"), std::string::npos);
}

TEST_F(SmallProject, ShipsTheCoursesRolesAndPoints) {
  course_.exercises[1].role = Role::optional;
  course_.exercises[1].points = 3;
  const Files shipped = files();
  const auto json = nlohmann::json::parse(shipped.at("exercises.json"));
  EXPECT_EQ(json["exercises"][0]["points"], 7.5);
  EXPECT_EQ(json["exercises"][1]["points"], 3);
  EXPECT_EQ(json["exercises"][1]["role"], "optional");
  EXPECT_EQ(shipped.at("assignment/README.md"),
            "# Exercises\n| E1 | [Exercise E1](E1.md) | `student/f.cpp` | - | 7.5 |\n"
            "| E2 | [Exercise E2](E2.md) | `student/g.cpp` | - | 3, extra credit |\n"
            "| `one` | E1 | x |\n| `two` | E1, E2 | x |\nGood luck\n");
}

TEST_F(SmallProject, GivesTheSameBytesAgain) {
  make_handout(sources_, course_, out_);
  make_handout(sources_, course_, root_ / "again.tar.gz");
  EXPECT_EQ(hair::bytes_of(out_), hair::bytes_of(root_ / "again.tar.gz"));
}

TEST_F(SmallProject, ClosesForAStaffFileInTheManifest) {
  std::ofstream(root_ / "handout/manifest.txt", std::ios::app) << "reference/g.cpp -> checks/example.cpp\n";
  EXPECT_NE(complaint().find("checks/example.cpp says STAFF ONLY"), std::string::npos);
}

TEST_F(SmallProject, ClosesForReferenceLinesInAText) {
  std::ofstream(root_ / "handout/README.md", std::ios::app) << kSolved.substr(kSolved.find('\n'));
  EXPECT_NE(complaint().find("README.md:3: what it says stands in reference/f.cpp:2"), std::string::npos);
}

TEST_F(SmallProject, AGivenExerciseOpensNothingElse) {
  course_.exercises[0].role = Role::given;
  write("handout/student/g.cpp", kSolved.substr(kSolved.find('\n')));
  EXPECT_NE(complaint().find("student/g.cpp"), std::string::npos);
}

TEST_F(SmallProject, LeavesTheOldArchiveWhenAGateCloses) {
  make_handout(sources_, course_, out_);
  const std::string before = hair::bytes_of(out_);
  write("handout/README.md", "STAFF ONLY\n");
  EXPECT_THROW(make_handout(sources_, course_, out_), HandoutError);
  EXPECT_EQ(hair::bytes_of(out_), before);
}

TEST_F(SmallProject, NamesWhatCantBeReadOrWritten) {
  EXPECT_THROW(make_handout(sources_, course_, root_), BadInput);
  EXPECT_THROW(make_handout(sources_, course_, root_ / "nowhere/handout.tar.gz"), BadInput);
  fs::remove(root_ / "build/golden/g.mtx");
  try {
    make_handout(sources_, course_, out_);
    FAIL() << "a golden file is missing";
  } catch (const BadInput& error) {
    EXPECT_NE(std::string(error.what()).find("manifest.txt:8"), std::string::npos) << error.what();
  }
}

class RealProject : public testing::Test {
 protected:
  fs::path root_ = HAIR_SOURCE_DIR;
  HandoutSources sources_{root_, HAIR_GOLDEN_DIR};
  Course course_ = read_course(root_ / "handout/exercises.json");
};

TEST_F(RealProject, PassesTheGatesInEveryRole) {
  const fs::path out = fs::path(HAIR_SCRATCH_DIR) / "real_handout.tar.gz";
  for (Role role : {Role::assigned, Role::optional, Role::given}) {
    for (Exercise& exercise : course_.exercises) exercise.role = role;
    make_handout(sources_, course_, out);
  }
}

TEST_F(RealProject, ForgetsNoFileThatStudentsNeed) {
  Paths listed;
  for (const ManifestLine& line : read_manifest(root_ / "handout/manifest.txt", course_))
    listed.insert(line.source);
  const Paths kept = {"handout/manifest.txt", "solver/README.md"};
  for (const std::string folder : {"handout", "solver"})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root_ / folder)) {
      const std::string path = entry.path().lexically_relative(root_).string();
      const bool ours = path.find("/tests/") != std::string::npos || path.starts_with("solver/bench/");
      if (!entry.is_regular_file() || kept.contains(path) || ours) continue;
      EXPECT_TRUE(listed.contains(path)) << path << " is not in handout/manifest.txt";
    }
}

TEST_F(RealProject, MakesGoldenDataThatShipsAsAWhole) {
  Paths listed;
  for (const ManifestLine& line : read_manifest(root_ / "handout/manifest.txt", course_))
    listed.insert(line.source);
  for (const fs::directory_entry& entry : fs::directory_iterator(sources_.golden)) {
    const std::string source = "golden/" + entry.path().filename().string();
    EXPECT_TRUE(listed.contains(source)) << source << " is not in handout/manifest.txt";
  }
}

// Where a link of a text leads, from the handout's top: "hair/README.md#grooms".
std::vector<std::string> links_of(const std::string& path, const std::string& text) {
  static const std::regex link("\\]\\(([^)\\s]+)\\)");
  std::vector<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), link), end; it != end; ++it) {
    const std::string target = (*it)[1];
    if (target.find(':') != std::string::npos) continue;
    found.push_back(target.starts_with("#")
                        ? path + target
                        : (fs::path(path).parent_path() / target).lexically_normal().string());
  }
  return found;
}

// "## States, and more" is #states-and-more.
bool has_place(const std::string& text, const std::string& place) {
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("#")) continue;
    std::string name;
    for (const char c : line.substr(line.find_first_not_of("# ")))
      if (c == ' ' || c == '-' || c == '_' || std::isalnum(static_cast<unsigned char>(c)))
        name += c == ' ' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (name == place) return true;
  }
  return false;
}

void expect_links_resolve(const Files& files) {
  for (const auto& [path, text] : files) {
    if (!path.ends_with(".md")) continue;
    for (const std::string& link : links_of(path, text)) {
      const std::string file = link.substr(0, link.find('#'));
      const auto below = files.lower_bound(file);  // itself, or a file of the folder
      EXPECT_TRUE(below != files.end() && below->first.starts_with(file)) << path << " links to " << link;
      if (link == file || !files.contains(file)) continue;
      EXPECT_TRUE(has_place(files.at(file), link.substr(file.size() + 1))) << path << " links to " << link;
    }
  }
}

// A text that mentions it says at its end that the course lacks it.
void expect_named_as_absent(const Exercise& exercise, const Files& files) {
  for (const auto& [path, text] : files) {
    if (!path.ends_with(".md") || text.find(" " + exercise.id + " ") == std::string::npos) continue;
    const std::size_t end = text.find("*Not part of your course: ");
    ASSERT_NE(end, std::string::npos) << path;
    EXPECT_NE(text.find(exercise.id + " (" + exercise.title + ")", end), std::string::npos) << path;
  }
}

// The points that an exercise's text names, and their sum over its categories; {-1, 0} if it names none.
std::pair<double, double> points_in(const std::string& text) {
  static const std::regex total("([0-9.]+) points, in these categories:"), row("\\| .+? \\| ([0-9.]+) \\|.*");
  std::pair<double, double> points{-1, 0};
  std::istringstream in(text);
  std::smatch match;
  for (std::string line; std::getline(in, line);) {
    if (std::regex_match(line, match, total))
      points.first = std::stod(match[1]);
    else if (points.first >= 0 && line.starts_with("#"))
      break;
    else if (points.first >= 0 && std::regex_match(line, match, row))
      points.second += std::stod(match[1]);
  }
  return points;
}

// Commands play scenes that are there, and nobody is asked to look at, study or copy another.
void expect_scenes_to_play(const Files& files, const std::vector<ManifestLine>& all) {
  for (const ManifestLine& line : all) {
    if (!line.destination.starts_with("hair/scenes/") || !line.destination.ends_with(".json")) continue;
    if (files.contains(line.destination)) continue;
    const std::string scene = fs::path(line.destination).stem().string();
    const std::regex plays("hairlab (run|study|stability)\\s+" + scene + "(?![a-z.-])|" + scene +
                           "\\.json|[a-z] (at|study)\\s+`" + scene + "`");
    for (const auto& [path, text] : files)
      EXPECT_FALSE(path.ends_with(".md") && std::regex_search(text, plays)) << path << " plays " << scene;
  }
}

// Nobody is asked to write what is given.
void expect_nothing_to_write(const Exercise& given, const Files& files) {
  const std::string& own = files.at(given.text);
  for (const char* asks : {"Write ", "ou write", "ou also write", "ou have written", "not implemented yet"})
    EXPECT_EQ(own.find(asks), std::string::npos) << given.text << ": " << asks;
  EXPECT_NE(own.find("\n\nGiven: "), std::string::npos) << given.text;
  std::string functions;
  for (const std::string& function : given.functions) {
    const std::string name = function.substr(0, function.find('('));
    functions += "|" + name.substr(name.rfind(':') + 1);  // rfind's npos + 1 is 0
  }
  const std::regex asks("[Ww]rite `?(" + given.id + functions + ")\\b|" + given.id +
                        " [A-Za-z_0-9]+ is not implemented|until " + given.id + " is written");
  for (const auto& [path, text] : files)
    EXPECT_FALSE(path.ends_with(".md") && std::regex_search(text, asks))
        << path << " asks to write " << given.id;
}

// Points stand where the course's are put: in the index's table and in an exercise's categories.
void expect_no_other_points(const Files& files) {
  static const std::regex number("\\b([Oo]ne|[Tt]wo|half a|[0-9.]+) points? (for|of|if|each|in)\\b"),
      categories("[0-9.]+ points, in these categories:");
  for (const auto& [path, text] : files) {
    if (!path.starts_with("assignment/") || !path.ends_with(".md") || path.ends_with("work-precision.md"))
      continue;
    for (std::sregex_iterator it(text.begin(), text.end(), number), end; it != end; ++it)
      EXPECT_TRUE(std::regex_search(text.begin() + it->position(), text.end(), categories,
                                    std::regex_constants::match_continuous))
          << path << ": " << it->str();
  }
}

TEST_F(RealProject, FitsAnyCourse) {
  const std::vector<ManifestLine> all = read_manifest(root_ / "handout/manifest.txt", course_);
  std::mt19937 random(1);
  for (int number = 0; number < 10; ++number) {
    // The first is the course as it is.
    for (Exercise& exercise : course_.exercises) {
      if (number == 0) continue;
      exercise.role = std::array{Role::assigned, Role::optional, Role::given, Role::absent}[random() % 4];
      exercise.points = 1 + static_cast<double>(random() % 80) / 2;
    }
    course_.partial = number % 2 == 1;
    const Files files = handout_files(sources_, course_);
    expect_links_resolve(files);
    expect_scenes_to_play(files, all);
    expect_no_other_points(files);
    // With all exercises none of a text's links was left out.
    if (number == 0) {
      Files texts = files;
      for (const ManifestLine& line : all)
        if (line.destination.ends_with(".md")) texts[line.destination] = hair::bytes_of(root_ / line.source);
      expect_links_resolve(texts);
    }

    const std::string& index = files.at("assignment/README.md");
    EXPECT_EQ(index.find("gives them if all of its checks hold") != std::string::npos, !course_.partial);
    EXPECT_EQ(index.find("in whole points") != std::string::npos, course_.partial);
    for (const Exercise& exercise : course_.exercises) {
      SCOPED_TRACE(exercise.id + ", " + to_string(exercise.role) + ", course " + std::to_string(number));
      const bool there = exercise.role != Role::absent;
      for (const std::string& file : {"student/" + exercise.file, exercise.text, exercise.checks})
        EXPECT_EQ(files.contains(file), there) << file;
      EXPECT_EQ(index.find(index_row(exercise) + "\n") != std::string::npos, there);
      if (!there) {
        expect_named_as_absent(exercise, files);
        continue;
      }
      const std::string& text = files.at(exercise.text);
      const auto [points, sum] = points_in(text);
      const bool given = exercise.role == Role::given;
      EXPECT_EQ(text.find("nothing of it is left to write") != std::string::npos, given);
      EXPECT_EQ(text.find("## Hints, in steps") == std::string::npos, given);
      if (given) expect_nothing_to_write(exercise, files);
      EXPECT_EQ(points, given ? -1 : exercise.points);
      // Each share is rounded to a hundredth.
      EXPECT_NEAR(sum, given ? 0 : exercise.points, 0.005 * 32);
    }
    // The scenes that the index names are there, and no others.
    for (const ManifestLine& line : all) {
      if (!line.destination.starts_with("hair/scenes/") || !line.destination.ends_with(".json")) continue;
      const std::string row = "| `" + fs::path(line.destination).stem().string() + "` |";
      EXPECT_EQ(files.contains(line.destination), index.find(row) != std::string::npos) << line.destination;
    }
  }
}

// An example's scene makes room for another; a scene that a paragraph is about does not.
TEST_F(RealProject, PlaysOtherScenesWithoutH6) {
  const std::vector<ManifestLine> all = read_manifest(root_ / "handout/manifest.txt", course_);
  for (Exercise& exercise : course_.exercises)
    if (exercise.id == "H6") exercise.role = Role::absent;
  const Files files = handout_files(sources_, course_);
  expect_scenes_to_play(files, all);
  const std::string& readme = files.at("README.md");
  for (const char* line : {"\nbuild/hairlab run long-straight --out swing      # plays it\n",
                           "\nbuild/hairlab run head-of-hair --jobs 2",
                           "\nbuild/hairlab study long-straight --out study            # error against run "
                           "time, of each method\n"})
    EXPECT_NE(readme.find(line), std::string::npos) << line << readme;
  EXPECT_NE(
      files.at("assignment/work-precision.md").find("\nbuild/hairlab study long-straight --out study\n"),
      std::string::npos);
  EXPECT_NE(files.at("assignment/H4-implicit-euler.md")
                .find("\n\n*(Not in your course: the scene angular-momentum.)*\n\n"),
            std::string::npos);
}

TEST_F(RealProject, BeginsWithAnExerciseThatIsToBeWritten) {
  for (Exercise& exercise : course_.exercises)
    if (exercise.id == "S1" || exercise.id == "S2") exercise.role = Role::given;
  const std::string readme = handout_files(sources_, course_).at("README.md");
  for (const char* words : {"--target check-P1 --parallel 4", "`P1 forward_euler is not implemented yet`",
                            "[student/explicit_integrators.cpp](student/explicit_integrators.cpp)"})
    EXPECT_NE(readme.find(words), std::string::npos) << words << readme;
}

// What a text asks for a command or a check prints; what the report does not say it does not promise.
TEST_F(RealProject, PromisesWhatIsThere) {
  const auto text = [&](const char* name) { return hair::bytes_of(root_ / "handout/assignment" / name); };
  EXPECT_NE(text("README.md").find("fewer than five checks, it says only that it is not right"),
            std::string::npos);
  // check-H5 goes to 60 segments.
  EXPECT_EQ(text("H5-length-correction.md").find("| 120 | 108,066 | |"), std::string::npos);
  // check.cpp calls each function before the checks: a breakpoint there stops in these calls first.
  for (const char* name : {"H4-implicit-euler.md", "S2-normal-equations.md"}) {
    const std::string recipe = text(name);
    const std::size_t at = recipe.find("(gdb) break YourMatrix::matVecMult");
    ASSERT_NE(at, std::string::npos) << name;
    EXPECT_LT(recipe.find("(gdb) tbreak testing::UnitTest::Run\n(gdb) run\n"), at) << name;
  }
}

TEST_F(RealProject, HasAnIndexThatAgreesWithTheListOfExercises) {
  const std::string index = hair::bytes_of(root_ / "handout/assignment/README.md");
  for (const Exercise& exercise : course_.exercises)
    EXPECT_NE(index.find(index_row(exercise) + "\n"), std::string::npos) << "it must have the row\n"
                                                                         << index_row(exercise);
}

}  // namespace
}  // namespace grader
