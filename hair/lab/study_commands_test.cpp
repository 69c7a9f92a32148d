// hairlab's studies refuse bad input, as seen from outside: in one line, before they compute, and without
// leaving files. `study` keeps its results when it is killed; `validate` runs what is asked for.
#include <gtest/gtest.h>
#include <signal.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>

#include "hair/lab/study/test_studies.h"
#include "hair/lab/test_run_hairlab.h"
#include "hair/truth/accurate_motion.h"

namespace hair {
namespace {

struct Refused {
  const char* command;  // words; '' is an empty one. OUT is a folder below two that are not there
  const char* says;     // a part of the line
};

const Refused kRefused[] = {
    {"stability strand-swing --out OUT --strand 1", "there is no strand 1"},
    {"stability FLOATING --out OUT", "nothing brings its strand back when it swings"},
    {"stability rigid-links --out OUT",
     "rigid-links: studies know no rigid_links; study a scene with hair of "},
    {"study", "SCENE is required"},
    {"study pendulum", "--out is required"},
    {"study ./head --out OUT", "./head"},
    {"study strand-swing --out OUT --methods leapfrog",
     "--methods: there is no \"leapfrog\"; there are forward-euler, "},
    {"study strand-swing --out OUT --methods ''", "--methods: there is no \"\"; "},
    {"study strand-swing --out OUT --strand 1", "there is no strand 1"},
    {"study strand-swing --out OUT --duration nan", "--duration: nan is not right; give 1e-6 to 1000"},
    {"study strand-swing --out OUT --duration 1001", "--duration: 1001 is not right; give 1e-6 to 1000"},
    {"study rigid-links --out OUT", "rigid-links: studies know no rigid_links; study a scene with hair of "},
    {"study head", "--out is required"},
    {"study head --out OUT --hair grey",
     "hairlab: --hair: there is no \"grey\"; there are straight, combed, wavy, curly\n"},
    {"study head --out OUT --exercise-strands 0", "--exercise-strands"},
    {"study head --out OUT --exercise-strands nan", "--exercise-strands"},
    {"study head --out OUT --duration 1", "--duration"},
    {"validate pendulum", "validate: there is no \"pendulum\"; there are published-numbers, "},
};

TEST(Studies, RefuseWhatIsNotThereInOneLine) {
  const TestFolder folder;
  const std::string floating = folder.write("floating.json", R"({"shows": "hair without weight", "frames": 3,
 "gravity": [0, 0, 0], "hair": [{"segments": 3, "length": 0.1, "clamped": false,
 "roots": {"list": [{"position": [0, 0, 0], "direction": [1, 0, 0]}]}}]})");
  const std::vector<std::string> before = folder.names();
  for (const Refused& one : kRefused) {
    SCOPED_TRACE(one.command);
    const std::string_view all = one.command;
    if (!have_accurate_motion() && all.starts_with("study ") && !all.starts_with("study head")) continue;
    std::vector<std::string> words;
    std::istringstream command(one.command);
    for (std::string word; command >> word;) {
      for (const auto& [name, meant] :
           {std::pair<std::string, std::string>{"OUT", (folder / "q/r/out").string()},
            {"FLOATING", floating},
            {"''", ""}})
        if (word.starts_with(name)) word.replace(0, name.size(), meant);
      words.push_back(word);
    }
    expect_refused(run_hairlab(words), 2, one.says);
    EXPECT_EQ(folder.names(), before);
  }
}

// Soft hair takes no time. The last study is killed, as after a hanging exercise and a second Ctrl-C; the
// whole of it would take ten seconds.
TEST(StudyCommand, KeepsTheAccurateMotionAndWhenItIsKilledTheRunsOfBefore) {
  if (!have_accurate_motion()) GTEST_SKIP() << "built without SUNDIALS";
  const TestFolder folder;
  const std::filesystem::path out = folder / "out";
  const auto record = [&] { return nlohmann::json::parse(bytes_of(out / "study.json")); };
  std::vector<std::string> words = {"study", folder.write("scene.json", reference_tests::kSoftHair), "--out",
                                    out.string()};
  std::vector<std::string> short_study = words;
  short_study.insert(short_study.end(),
                     {"--quick", "--duration", "0.05", "--methods", "symplectic-euler,runge-kutta-4"});
  ProgramSettings settings{.environment = {"XDG_CACHE_HOME=" + (folder / "cache").string()}};
  for (const bool kept : {false, true}) {
    ASSERT_EQ(run_hairlab(short_study, settings).code, 0);
    EXPECT_EQ(record()["finished"], true);
    EXPECT_EQ(record()["reference"]["from_cache"], kept);
  }
  std::filesystem::remove_all(out);
  settings.meanwhile = [&](int process) {
    EXPECT_TRUE(wait_until([&] { return std::filesystem::exists(out / "study.json"); }, process));
    kill(process, SIGKILL);
  };
  const ProgramRun run = run_hairlab(words, settings);
  ASSERT_EQ(run.code, -1) << run.output << run.errors;
  EXPECT_EQ(record()["finished"], false);
  EXPECT_FALSE(record()["methods"][0]["runs"].empty());
  EXPECT_TRUE(says(bytes_of(out / "index.html"), "Interrupted: finer steps are missing of "));
}

TEST(ValidateCommand, ListsWhatThereIsInTheCourse) {
  const TestFolder folder;
  const std::string course = folder.write("course.json", R"({"exercises": {"H6": {"role": "absent"}}})");
  const std::string all = run_hairlab({"validate", "--list"}).output,
                    some = run_hairlab({"validate", "--list", "--course", course}).output;
  EXPECT_TRUE(says(all, "published-numbers: ") && says(all, "(no exercise)"));
  EXPECT_TRUE(says(all, "chain-h6: ") && says(all, "(S1, H1, H4, H5, H6)"));
  EXPECT_TRUE(says(some, "published-numbers: ") && !says(some, "H6"));
}

TEST(ValidateCommand, RunsThoseThatAreAskedForInTheListsOrder) {
  const ProgramRun run = run_hairlab({"validate", "pendulum-rods", "published-numbers"});
  EXPECT_EQ(run.code, 0) << run.errors;
  EXPECT_EQ(run.errors, "") << "progress is for terminals";
  EXPECT_LT(run.output.find("published-numbers: "), run.output.find("pendulum-rods: ")) << run.output;
  EXPECT_FALSE(says(run.output, "chain-h6"));
  EXPECT_TRUE(says(run.output, "20 of 20 checks hold\n"));
}

// Validations that call no exercise can run, but nobody asks for them alone.
TEST(ValidateCommand, SaysWhatIsNotWrittenYet) {
  const ProgramSettings student{.program = STUDENT_HAIRLAB};
  const ProgramRun all = run_hairlab({"validate", "--quick"}, student);
  EXPECT_EQ(all.code, 3);
  EXPECT_TRUE(says(all.output, "left out: it needs P1: student/explicit_integrators.cpp, "));
  const ProgramRun numbers = run_hairlab({"validate", "published-numbers"}, student);
  EXPECT_EQ(numbers.code, 0) << numbers.errors;
}

}  // namespace
}  // namespace hair
