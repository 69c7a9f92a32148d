// STAFF ONLY. Tests handouts of the real project, for any course.

#include "grader/package/handout.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <random>
#include <regex>
#include <set>
#include <sstream>

#include "grader/course/input.h"
#include "grader/intake/read_submissions.h"
#include "grader/package/course_texts.h"
#include "grader/package/manifest.h"
#include "grader/package/pages.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_refusal.h"

namespace grader::inline package {
namespace {

namespace fs = std::filesystem;
using tests::says;

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
  for (const ManifestLine& line : read_manifest(root_, course_)) listed.insert(line.source);
  const Paths kept = {"handout/manifest.txt", "handout/packed.txt", "solver/README.md"};
  for (const std::string folder : {"handout", "solver"})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root_ / folder)) {
      const std::string path = entry.path().lexically_relative(root_).string();
      const bool ours = is_test_by_name(path) || path.starts_with("solver/bench/");
      if (!entry.is_regular_file() || kept.contains(path) || ours) continue;
      EXPECT_TRUE(listed.contains(path)) << path << " is not in handout/manifest.txt";
    }
}

TEST_F(RealProject, MakesGoldenDataThatShipsAsAWhole) {
  Paths listed;
  for (const ManifestLine& line : read_manifest(root_, course_)) listed.insert(line.source);
  for (const fs::directory_entry& entry : fs::directory_iterator(sources_.golden)) {
    if (entry.is_directory()) continue;  // skips runs of the scenes that ship
    const std::string source = "golden/" + entry.path().filename().string();
    EXPECT_TRUE(listed.contains(source)) << source << " is not in handout/manifest.txt";
  }
}

// Returns the targets of a text's links, from the handout's top: "given/hair/README.md#grooms".
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

// A text that mentions the exercise says at its end that the course lacks it.
void expect_named_as_absent(const Exercise& exercise, const Files& files) {
  for (const auto& [path, text] : files) {
    if (!path.ends_with(".md") || text.find(" " + exercise.id + " ") == std::string::npos) continue;
    const std::size_t end = text.find("*Not part of your course: ");
    ASSERT_NE(end, std::string::npos) << path;
    EXPECT_NE(text.find(exercise.id + " (" + exercise.title + ")", end), std::string::npos) << path;
  }
}

// Returns the points in an exercise's text, and their sum over its categories; {-1, 0} without points.
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

// The scene of show-X calls X, and ships. Studies show solver and phase plane.
TEST_F(RealProject, ShowsEachExerciseByASceneThatCallsIt) {
  const std::string scenes = hair::bytes_of(sources_.golden / "scenes.md");
  static const std::regex view("view ([a-z-]+) --with reference");
  for (const Exercise& exercise : course_.exercises) {
    std::smatch found;
    if (!std::regex_match(exercise.show, found, view)) {
      EXPECT_TRUE(exercise.show.starts_with("bowl ") || exercise.show.starts_with("phase "))
          << exercise.id << ": " << exercise.show;
      continue;
    }
    const std::string name = "| [" + found[1].str() + "](" + found[1].str() + ".json) | ";
    const std::size_t at = scenes.find(name);
    ASSERT_NE(at, std::string::npos) << exercise.id << ": " << exercise.show;
    const std::size_t begin = at + name.size();
    const std::string called = ", " + scenes.substr(begin, scenes.find(" |", begin) - begin) + ",";
    EXPECT_TRUE(says(called, ", " + exercise.id + ",")) << exercise.id << ": ";
  }
}

// Commands run only scenes that ship, and no text tells a student to look at, study or copy another.
void expect_scenes_to_play(const Files& files, const std::vector<ManifestLine>& all) {
  for (const ManifestLine& line : all) {
    if (!line.destination.starts_with("given/hair/scenes/") || !line.destination.ends_with(".json")) continue;
    if (files.contains(line.destination)) continue;
    const std::string scene = fs::path(line.destination).stem().string();
    const std::regex plays("hairlab (run|view|study|stability)\\s+" + scene + "(?![a-z.-])|" + scene +
                           "\\.json|[a-z] (at|study)\\s+`" + scene + "`");
    for (const auto& [path, text] : files)
      EXPECT_FALSE(path.ends_with(".md") && std::regex_search(text, plays)) << path << " plays " << scene;
  }
}

// Points stand only in the index's table and in an exercise's categories, where the course's are filled in.
void expect_no_other_points(const Files& files) {
  static const std::regex number("\\b([Oo]ne|[Tt]wo|half a|[0-9.]+) points? (for|of|if|each|in)\\b"),
      categories("[0-9.]+ points, in these categories:");
  for (const auto& [path, text] : files) {
    if (!path.ends_with(".md") || path.starts_with("given/") || path.ends_with("work-precision.md")) continue;
    for (std::sregex_iterator it(text.begin(), text.end(), number), end; it != end; ++it)
      EXPECT_TRUE(std::regex_search(text.begin() + it->position(), text.end(), categories,
                                    std::regex_constants::match_continuous))
          << path << ": " << it->str();
  }
}

TEST_F(RealProject, FitsAnyCourse) {
  const std::vector<ManifestLine> all = read_manifest(root_, course_);
  std::mt19937 random(1);
  for (int number = 0; number < 10; ++number) {
    // The first course is the project's.
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
    // With all exercises no link of a text is removed, and the index is the one in the project.
    for (const ManifestLine& line : all)
      if (number == 0 && line.source.ends_with(".md") && !line.source.starts_with("golden/")) {
        EXPECT_EQ(links_of(line.destination, files.at(line.destination)).size(),
                  links_of(line.source, hair::bytes_of(root_ / line.source)).size())
            << line.source;
      }

    const std::string& index = files.at("assignment/README.md");
    const std::string project = hair::bytes_of(root_ / "handout/assignment/README.md");
    const std::size_t table = project.find("| id |");
    EXPECT_TRUE(number > 0 || says(index, project.substr(table, project.find("\n\n", table) - table)));
    EXPECT_EQ(index.find("its points if all of its checks hold") != std::string::npos, !course_.partial);
    EXPECT_EQ(index.find("in whole points") != std::string::npos, course_.partial);
    for (const Exercise& exercise : course_.exercises) {
      SCOPED_TRACE(exercise.id + ", " + to_string(exercise.role) + ", course " + std::to_string(number));
      const bool there = exercise.role != Role::absent;
      const std::string text_file = exercise.folder + "/text.md";
      for (const std::string& file : {stub_of(exercise), text_file, exercise.folder + "/check.cpp"})
        EXPECT_EQ(files.contains(file), there) << file;
      EXPECT_EQ(index.find("\n| " + exercise.id + " | [") != std::string::npos, there);
      if (!there) {
        expect_named_as_absent(exercise, files);
        continue;
      }
      const std::string& text = files.at(text_file);
      static const std::regex mistake("\n- \\*[^\n]*\\.\\* ");
      EXPECT_EQ(std::distance(std::sregex_iterator(text.begin(), text.end(), mistake), {}), 5);
      const auto [points, sum] = points_in(text);
      const bool given = exercise.role == Role::given;
      EXPECT_EQ(text.find("nothing of it is left to write") != std::string::npos, given);
      EXPECT_EQ(points, given ? -1 : exercise.points);
      // Each share is rounded to a hundredth.
      EXPECT_NEAR(sum, given ? 0 : exercise.points, 0.005 * 32);
    }
    // Exactly the scenes in their list ship.
    const std::string& scenes = files.at("given/hair/scenes/scenes.md");
    for (const ManifestLine& line : all) {
      if (!line.destination.starts_with("given/hair/scenes/") || !line.destination.ends_with(".json"))
        continue;
      const std::string row = "(" + fs::path(line.destination).filename().string() + ") |";
      EXPECT_EQ(files.contains(line.destination), scenes.find(row) != std::string::npos) << line.destination;
    }
  }
}

// Some hand in the whole folder, or the two folders whose names promise their files.
TEST_F(RealProject, IsAHandInAsAWhole) {
  for (const bool whole : {true, false}) {
    const hair::TemporaryFolder folder("handout");
    const auto write = [&](const std::string& name, const std::string& text) {
      const fs::path file = folder.path() / "alice" / name;
      fs::create_directories(file.parent_path());
      std::ofstream(file, std::ios::binary) << text;
    };
    for (const auto& [name, text] : handout_files(sources_, course_))
      if (whole || name.starts_with("stubs/")) write(name, text);
    for (const std::string& page : with_pages({"README.md", "exercises/H1/text.md"})) write(page, "a page");
    write("student/conj_grad.cpp", "mine");
    write("student/about.txt", "Hours: 3\n");
    const std::vector<Submission> all =
        read_submissions({folder.path() / "alice"}, course_, open_here).submissions;
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].name, "alice");
    EXPECT_EQ(all[0].problem, "");
    EXPECT_EQ(all[0].about, "Hours: 3\n");
    EXPECT_EQ(all[0].files.at("conj_grad.cpp").text, "mine");
    EXPECT_EQ(all[0].files.at("conj_grad.cpp").problem, "");
  }
}

// The build needs the packages in packages.cmake.
TEST_F(RealProject, NamesAllPackagesInTheReadme) {
  const std::string readme = hair::bytes_of(root_ / "handout/README.md");
  const std::size_t debian = readme.find("\n**Debian, Ubuntu**"), macos = readme.find("\n**macOS**"),
                    windows = readme.find("\n**Windows**");
  ASSERT_TRUE(debian < macos && macos < windows && windows != std::string::npos);
  // Lists the words of all lines that begin with this command.
  const auto installed = [&](std::size_t from, std::size_t to, const std::string& command) {
    std::set<std::string> words;
    std::istringstream lines(readme.substr(from, to - from));
    for (std::string line; std::getline(lines, line);)
      if (line.starts_with(command)) {
        std::istringstream rest(line.substr(command.size()));
        for (std::string word; rest >> word;) words.insert(word);
      }
    return words;
  };
  std::set<std::string> apt = installed(debian, macos, "sudo apt install "),
                        brew = installed(macos, windows, "brew install ");
  std::istringstream list(hair::bytes_of(root_ / "handout/cmake/packages.cmake"));
  int packages = 0;
  for (std::string line; std::getline(list, line);) {
    std::istringstream row(line);
    std::string need, for_apt, for_brew;
    if (!line.starts_with("  ") || !(row >> need >> for_apt >> for_brew) ||
        (need != "checks" && need != "hairlab" && need != "live" && need != "studies"))
      continue;
    ++packages;
    if (for_brew.ends_with(")")) for_brew.pop_back();
    EXPECT_EQ(apt.erase(for_apt), 1u) << for_apt;
    if (for_brew == "-") continue;
    EXPECT_EQ(brew.erase(for_brew), 1u) << for_brew;
  }
  EXPECT_EQ(packages, 11);
  EXPECT_EQ(apt, (std::set<std::string>{"build-essential", "gdb"}));
  EXPECT_EQ(brew, std::set<std::string>());
}

// Lists the project's headers that a text includes, "hair/strand.h".
std::vector<std::string> included_by(const std::string& text) {
  static const std::regex line("#include \"([^\"]+)\"");
  std::vector<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), line), end; it != end; ++it)
    found.push_back((*it)[1]);
  return found;
}

// On top lie only the exercises' headers and those that these and the stubs include.
TEST(ContractsOnTop, AreThereAndNoOtherGivenCode) {
  const fs::path root = HAIR_SOURCE_DIR;
  const Course course = read_course(root / "handout/exercises.json");
  const Files files = handout_files({root, HAIR_GOLDEN_DIR}, course);
  std::vector<std::string> open = {"solver/lecture/linearSolver.h"};
  for (const Exercise& exercise : course.exercises) {
    open.push_back(exercise.header);
    for (const std::string& header : included_by(files.at(stub_of(exercise)))) open.push_back(header);
  }
  Paths contracts;
  while (!open.empty()) {
    const std::string header = open.back();
    open.pop_back();
    if (!contracts.insert(header).second) continue;
    ASSERT_TRUE(files.contains(header)) << header << " is a contract or a part of one, and must lie on top";
    for (const std::string& other : included_by(files.at(header))) open.push_back(other);
  }
  for (const auto& [path, text] : files)
    for (const char* room : {"solver/", "particles/", "hair/"})
      EXPECT_TRUE(!path.starts_with(room) || contracts.contains(path)) << path << " must lie below given/";
}

}  // namespace
}  // namespace grader::package
