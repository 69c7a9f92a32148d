// STAFF ONLY. Tests a student's way from the archive to the hand-in, in an empty folder, with nothing else of
// the project there.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "grader/intake/read_submissions.h"
#include "grader/package/handout.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/start_program.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_refusal.h"

namespace grader::inline package {
namespace {

namespace fs = std::filesystem;
using tests::says;

struct Ran {
  int code;
  std::string output;
};

bool says_not_implemented(const std::string& output, const std::string& id) {
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(id + " ") && line.ends_with(" is not implemented yet")) return true;
  return false;
}

class StudentsWay : public testing::Test {
 protected:
  // Unpacks the handout of the whole course, which is made once, or that of another.
  void unpack() { unpack(whole_course()); }
  void unpack(const fs::path& archive) {
    fs::copy_file(archive, folder_ / "handout.tar.gz");
    does("sh -c 'cd .. && cmake -E tar xf handout.tar.gz'");
  }
  static fs::path made(const Course& course, const fs::path& archive) {
    make_handout({HAIR_SOURCE_DIR, HAIR_GOLDEN_DIR}, course, archive);
    return archive;
  }
  static const fs::path& whole_course() {
    static const hair::TemporaryFolder folder("hair-handout");
    static const fs::path archive = made(read_course(fs::path(HAIR_SOURCE_DIR) / "handout/exercises.json"),
                                         folder.path() / "whole.tar.gz");
    return archive;
  }

  // Runs a command in the handout's folder, with the environment of a new shell.
  Ran run(const std::string& command) const {
    fs::create_directories(folder_ / "hair-assignment");
    const std::string line = "env -i PATH=\"$PATH\" HOME='" + folder_.string() + "' TMPDIR='" +
                             folder_.string() + "' " + command + " 2>&1";
    const auto code = hair::exit_code_of(hair::start_program({.words = {"/bin/sh", "-c", line},
                                                              .output = folder_ / "said",
                                                              .folder = folder_ / "hair-assignment"}));
    return {code.value_or(-1), hair::bytes_of(folder_ / "said")};
  }

  // Runs a command that must succeed, and returns its output.
  std::string does(const std::string& command) const {
    Ran ran = run(command);
    if (ran.code != 0) throw std::runtime_error(command + " failed:\n" + ran.output);
    return std::move(ran.output);
  }
  // Starts checks, whose AddressSanitizer must work wherever the kernel puts memory. Code 77: this machine
  // can't try it.
  Ran start(int times, const std::string& programs) const {
    return run("'" + (sources_.root / "grader/tests/random_addresses").string() + "' " +
               std::to_string(times) + " --gtest_list_tests " + programs);
  }

  void go_from_the_archive_to_the_hand_in(const std::string& options = "");

  void solve() const {
    fs::create_directories(folder_ / "hair-assignment/student");
    for (const Exercise& exercise : course_.exercises)
      fs::copy_file(sources_.root / solution_of(exercise),
                    folder_ / "hair-assignment/student" / exercise.file,
                    fs::copy_options::overwrite_existing);
  }

  hair::TemporaryFolder temporary_{"hair-student"};
  fs::path folder_ = temporary_.path();
  const std::string configure_ = "cmake --preset release";
  HandoutSources sources_{HAIR_SOURCE_DIR, HAIR_GOLDEN_DIR};
  Course course_ = read_course(sources_.root / "handout/exercises.json");
};

class SlowWay : public StudentsWay {};

void StudentsWay::go_from_the_archive_to_the_hand_in(const std::string& options) {
  unpack();
  does(configure_ + " -DSTUDENT=ada" + options);
  Ran ran = run("cmake --build build --parallel 2 --target check-S1");
  EXPECT_EQ(ran.code, 0) << "it tells, and the build tool adds nothing";
  EXPECT_TRUE(says(ran.output, "\nS1 ConjGrad is not implemented yet\n"));
  ran = run("cmake --build build --parallel 2 --target check");
  EXPECT_NE(ran.code, 0);
  for (const Exercise& exercise : course_.exercises)
    EXPECT_TRUE(says_not_implemented(ran.output, exercise.id)) << exercise.id << "\n" << ran.output;

  const fs::path s2 = folder_ / "hair-assignment/student/normal_equations.cpp";
  fs::copy_file(sources_.root / "reference/S2/normal_equations.cpp", s2,
                fs::copy_options::overwrite_existing);
  ran = run("cmake --build build --target check-S2");
  EXPECT_FALSE(says(ran.output, " pass\n")) << "S2 can't pass without S1";
  EXPECT_TRUE(says(ran.output, "\nS1 ConjGrad is not implemented yet\n"));

  solve();
  EXPECT_TRUE(says(does("cmake --build build --parallel 2 --target all check hairlab"), "100% tests passed"));
  ran = start(0, "build/student_*_check");
  EXPECT_EQ(ran.code, 0) << ran.output;
  does("build/hairlab run strand-swing --out swing --frames 2");
  const fs::path swing = folder_ / "hair-assignment/swing";
  for (const char* name : {"frame-0000.png", "frame-0002.png", "run.json", "states.bin", "states.csv"})
    EXPECT_TRUE(fs::exists(swing / name)) << name;

  const fs::path own = folder_ / "hair-assignment/student";
  std::ofstream(own / "about.txt") << "Hours: 12\nHardest: H6\nUnclear: nothing; [all] \"fine\"\n";
  fs::copy_file(sources_.root / "handout/exercises/H5/length_correction.cpp", own / "length_correction.cpp",
                fs::copy_options::overwrite_existing);
  std::ofstream(own / "bend_springs.cpp", std::ios::app) << "\n";
  does("sh -c 'cd .. && cmake -E tar xf handout.tar.gz'");  // a newer handout over it
  const std::string checked = does("cmake --build build --target handin");
  fs::copy_file(sources_.root / "reference/H5/length_correction.cpp", own / "length_correction.cpp",
                fs::copy_options::overwrite_existing);
  for (const char* line :
       {" public checks pass\n",
        "bend_springs.cpp          not checked since its last change: build check-H3\n",
        "length_correction.cpp     3 functions are not written yet\n", "your answers to three questions\n"})
    EXPECT_TRUE(says(checked, line));
  const fs::path archive = folder_ / "hair-assignment/build/ada.zip";
  EXPECT_TRUE(says(does("cmake --build build --target handin"), "Wrote " + archive.string()));
  const std::vector<Submission> submissions = read_submissions({archive}, course_, open_here).submissions;
  ASSERT_EQ(submissions.size(), 1u);
  EXPECT_EQ(submissions[0].name, "ada");
  ASSERT_EQ(submissions[0].files.size(), course_.exercises.size());
  for (const Exercise& exercise : course_.exercises)
    EXPECT_EQ(submissions[0].files.at(exercise.file).text,
              hair::bytes_of(sources_.root / solution_of(exercise)) +
                  (exercise.file == "bend_springs.cpp" ? "\n" : ""));
  EXPECT_EQ(submissions[0].about, "Hours: 12\nHardest: H6\nUnclear: nothing; [all] \"fine\"\n\nHandout: " +
                                      handout_files(sources_, course_).at("version.txt"));
}

TEST_F(StudentsWay, LeadsFromTheArchiveToTheHandIn) {
  go_from_the_archive_to_the_hand_in();
}

TEST_F(SlowWay, LeadsThereWithAnotherCompiler) {
  const std::string compiler = HAIR_OTHER_COMPILER;
  if (!fs::exists(compiler)) GTEST_SKIP() << "there is no clang++; it is in the package clang";
  go_from_the_archive_to_the_hand_in(" -DCMAKE_CXX_COMPILER=" + compiler);
  const Ran ran = start(1000, "build/student_S2_check build/student_H4_check");
  EXPECT_TRUE(ran.code == 0 || ran.code == 77) << ran.output;
}

// hairlab names exercises that are not written, and libraries that only studies use are there, too. stb
// writes pictures without zlib.
TEST_F(SlowWay, HasStudies) {
  unpack();
  does(configure_ + " -DCMAKE_DISABLE_FIND_PACKAGE_ZLIB=ON");
  does("cmake --build build --parallel 2 --target hairlab");
  Ran ran = run("build/hairlab run strand-swing --out swing --frames 2");
  EXPECT_EQ(ran.code, 3);
  EXPECT_EQ(
      ran.output,
      "hairlab: strand-swing needs H1: student/stretch_springs.cpp, stretch_energy is not implemented yet; "
      "nor "
      "are S1 (student/conj_grad.cpp), H2 (student/angular_springs.cpp), H4 (student/implicit_euler.cpp), H5 "
      "(student/length_correction.cpp), H6 (student/predictor_corrector.cpp)\n");
  EXPECT_FALSE(fs::exists(folder_ / "hair-assignment/swing"));

  solve();
  does("cmake --build build --parallel 2 --target hairlab");
  const std::string asked = "cmake --build '" + (folder_ / "hair-assignment/build").string() +
                            "' --target hairlab_studies --parallel 4";
  ran = run("build/hairlab validate published-numbers");
  EXPECT_EQ(ran.code, 2);
  EXPECT_EQ(
      ran.output,
      "hairlab: validate is in a program of its own, which is not built yet; build it with: " + asked + "\n");
  does(asked);
  does("build/hairlab validate published-numbers");
  does("cmake --build build --parallel 2 --target show-S1");
  EXPECT_TRUE(fs::exists(folder_ / "hair-assignment/build/bowl/index.html"));

  does("cmake --build build --parallel 2 --target student_S1_check");
  ran = start(1000, "build/student_S1_check");
  EXPECT_TRUE(ran.code == 0 || ran.code == 77) << ran.output;

  // The exercises move all strands of this head: the fast head is the staff's.
  does("build/hairlab study head --hair straight --quick --out head");
  for (const char* name : {"index.html", "head.json", "head.csv", "straight-every.png"})
    EXPECT_TRUE(fs::exists(folder_ / "hair-assignment/head" / name)) << name;
}

// Returns the lines of the first block of commands behind a heading of the README.
std::vector<std::string> commands_behind(const std::string& readme, const std::string& heading) {
  const std::size_t begin = readme.find("```\n", readme.find(heading)) + 4;
  std::istringstream block(readme.substr(begin, readme.find("```", begin) - begin));
  std::vector<std::string> lines;
  for (std::string line; std::getline(block, line);) lines.push_back(line);
  return lines;
}

// Goes from an empty folder to hair of one's own in a browser: it unpacks, writes two files, and follows the
// README.
TEST_F(SlowWay, IsShortToTheFirstHair) {
  unpack();
  const fs::path own = folder_ / "hair-assignment";
  fs::create_directories(own / "student");
  for (const char* id : {"P1", "H1"}) {
    const Exercise& exercise = *course_.find(id);
    fs::copy_file(sources_.root / solution_of(exercise), own / "student" / exercise.file);
  }
  const std::string readme = hair::bytes_of(own / "README.md");
  std::vector<std::string> commands = commands_behind(readme, "\n## Look at your hair\n");
  ASSERT_TRUE(says(readme, "`hairlab view limp-hair`"));
  commands.emplace_back("build/hairlab view limp-hair");
  EXPECT_LE(commands.size() + 2, 5u) << "with unpacking, and with the two files";
  for (const std::string& command : commands)
    EXPECT_FALSE(says(does(command), "not implemented")) << "it is one's own";
  ASSERT_TRUE(fs::exists(own / "limp-hair.html"));
  const Ran browser =
      run("sh -c 'command -v chromium || exit 77; chromium --headless --no-sandbox --disable-gpu "
          "--disable-quic --no-first-run "
          "--disable-background-networking --disable-component-update --disable-sync --use-angle=swiftshader "
          "--enable-unsafe-swiftshader --virtual-time-budget=3000 --dump-dom \"file://$PWD/limp-hair.html\" "
          "2>/dev/null'");
  if (browser.code == 77) GTEST_SKIP() << "there is no chromium; it is in the package chromium";
  EXPECT_EQ(browser.code, 0);
  EXPECT_TRUE(says(browser.output, "limp-hair"));
  const std::size_t moment = browser.output.find("id=\"moment\"");
  ASSERT_NE(moment, std::string::npos) << browser.output.substr(0, 2000);
  EXPECT_TRUE(says(browser.output.substr(moment, 200), " s"))
      << "the page's script says the time that it shows: ";
}

// Packages that only hairlab needs are missing: they are named, and the rest is configured.
TEST_F(StudentsWay, GoesWithoutHairlabsPackages) {
  unpack();
  const std::string told = does(
      configure_ + " -DCMAKE_DISABLE_FIND_PACKAGE_nlohmann_json=ON -DCMAKE_DISABLE_FIND_PACKAGE_CLI11=ON");
  for (const char* words : {"hairlab is left out", "apt install nlohmann-json3-dev libcli11-dev.",
                            "brew install nlohmann-json cli11;"})
    EXPECT_TRUE(says(told, words));
}

// Makes packages of Eigen that state their version, with this machine's Eigen in them.
TEST_F(StudentsWay, TakesEigenFromVersion33On) {
  unpack();
  for (const std::string version : {"3.2.9", "3.3.0", "5.0.1"}) {
    const fs::path package = folder_ / ("eigen-" + version);
    fs::create_directories(package);
    // As in Eigen's own package, another first number is not compatible.
    std::ofstream(package / "Eigen3ConfigVersion.cmake")
        << "set(PACKAGE_VERSION " << version << ")\n"
        << "if(PACKAGE_FIND_VERSION_MAJOR STREQUAL \"" << version[0]
        << "\" AND NOT PACKAGE_VERSION VERSION_LESS PACKAGE_FIND_VERSION)\n"
        << "  set(PACKAGE_VERSION_COMPATIBLE TRUE)\nendif()\n";
    std::ofstream(package / "Eigen3Config.cmake")
        << "add_library(Eigen3::Eigen INTERFACE IMPORTED)\n"
        << "target_include_directories(Eigen3::Eigen INTERFACE /usr/include/eigen3)\n";
    const Ran ran =
        run(configure_ + " -B 'build-" + version + "' '-DEigen3_DIR:PATH=" + package.string() + "'");
    if (version == "3.2.9") {
      EXPECT_NE(ran.code, 0);
      EXPECT_TRUE(says(ran.output, "Eigen is missing, version 3.3 or later."));
    } else {
      EXPECT_EQ(ran.code, 0) << version << "\n" << ran.output;
      // CMake must not find another one.
      const std::string cache =
          hair::bytes_of(folder_ / "hair-assignment" / ("build-" + version) / "CMakeCache.txt");
      EXPECT_TRUE(says(cache, "\nEigen3_DIR:PATH=" + package.string() + "\n")) << version;
    }
  }
}

TEST_F(StudentsWay, LeavesGivenExercisesOutOfTheHandIn) {
  course_.exercises[0].role = Role::given;
  unpack(made(course_, folder_ / "without-the-first.tar.gz"));
  does(configure_);
  does("cmake --build build --target handin");
  std::string others;
  for (const Exercise& exercise : course_.exercises)
    if (exercise.role != Role::given) others += exercise.file + "\n";
  EXPECT_EQ(does("cmake -E tar tf build/handin.zip"), others + "about.txt\n");
}

// The build has definitions in the place of absent exercises, and links all given code.
TEST_F(StudentsWay, ConfiguresWithoutAnExerciseThatTheCourseLacks) {
  course_.exercises.back().role = Role::absent;
  unpack(made(course_, folder_ / "without-the-last.tar.gz"));
  does(configure_);
  does("cmake --build build --target hair_not_in_course");
  EXPECT_FALSE(fs::exists(folder_ / "hair-assignment/student" / course_.exercises.back().file));
}

TEST_F(StudentsWay, HasADebugBuildAndChecksTheStudentsName) {
  unpack();
  does("cmake --preset debug");
  // Compiles a program with the preset's sanitizers alone.
  const std::string link =
      hair::bytes_of(folder_ / "hair-assignment/build-debug/CMakeFiles/student_example1.dir/link.txt");
  EXPECT_TRUE(says(link, " -no-pie "));
  const Ran named = run(configure_ + " '-DSTUDENT=../ada'");
  EXPECT_NE(named.code, 0);
  EXPECT_TRUE(says(named.output, "STUDENT is \"../ada\""));
}

}  // namespace
}  // namespace grader::package
