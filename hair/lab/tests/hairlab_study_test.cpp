// hairlab study from outside: how it resumes, and its record.
#include <gtest/gtest.h>
#include <signal.h>

#include <nlohmann/json.hpp>

#include "hair/lab/tests/run_hairlab.h"

namespace hair {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

// Soft, so that it takes no time.
const char* const kSoftHair = R"({"shows": "soft hair", "frames": 3, "hair": [{"segments": 6, "length": 0.12,
 "clamped": false, "material": {"stretch_factor": 1e-4},
 "roots": {"list": [{"position": [0, 0, 0], "direction": [1, 0, 0]}]}}]})";

// Rigid links, soft as well.
constexpr int kLinks = 4;
constexpr double kLinksLength = 0.08;
const char* const kSoftLinks = R"({"shows": "soft links", "frames": 3, "method": "implicit_euler",
 "hair": [{"model": "rigid_links", "segments": 4, "length": 0.08,
 "material": {"bend_factor": 1e-3, "twist_factor": 1e-6},
 "roots": {"list": [{"position": [0, 0, 0], "direction": [1, 0, 0]}]}}]})";

class HairlabStudy : public testing::Test {
 protected:
  // Short sweeps of few methods.
  ProgramRun study(std::vector<std::string> more = {}, ProgramSettings settings = {}) {
    std::vector<std::string> arguments = {
        "study", folder_.write("scene.json", kSoftHair), "--out", out_.string(), "--quick", "--duration",
        "0.05"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    settings.environment.push_back("XDG_CACHE_HOME=" + (folder_ / "cache").string());
    return run_hairlab(arguments, settings);
  }
  // Waits until a run is finished and kept.
  void wait_for_a_run(int process) const {
    EXPECT_TRUE(wait_until([&] { return fs::exists(out_ / "study.json"); }, process));
  }
  Json record() const { return Json::parse(bytes_of(out_ / "study.json")); }

  TestFolder folder_;
  const fs::path out_ = folder_ / "out";
  const std::vector<std::string> kFew = {"--methods", "symplectic-euler,runge-kutta-4"};
  const std::vector<std::string> kMany = {"--methods", "symplectic-euler,h4-filtered,h6"};
};

TEST_F(HairlabStudy, KeepsTheAccurateMotionAndResumedItIsTheSame) {
  ASSERT_EQ(study(kFew).code, 0);
  const Json json = record();
  EXPECT_EQ(json["finished"], true);
  EXPECT_EQ(json["reference"]["from_cache"], false);
  ASSERT_EQ(study({"--methods", kFew[1], "--resume"}).code, 0);
  const Json again = record();
  EXPECT_EQ(again["reference"]["from_cache"], true);
  EXPECT_EQ(again["methods"], json["methods"]);
}

TEST_F(HairlabStudy, InterruptedKeepsWhatIsFinishedAndGoesOn) {
  ProgramSettings settings;
  settings.meanwhile = [&](int process) {
    wait_for_a_run(process);
    kill(process, SIGINT);
  };
  const ProgramRun run = study(kMany, settings);
  if (run.code == 0) GTEST_SKIP() << "it was finished before it was interrupted";
  ASSERT_EQ(run.code, 130) << run.output << run.errors;
  EXPECT_TRUE(has(run.errors, "interrupted; what is finished is kept, and --resume goes on")) << run.errors;
  const Json part = record();
  EXPECT_EQ(part["finished"], false);
  EXPECT_TRUE(has(bytes_of(out_ / "index.html"), "--resume goes on"));

  // It can't resume another study.
  expect_refused(study({"--resume", "--methods", "h6"}), 2,
                 "is another study, and can't be resumed: its \"methods\"");
  EXPECT_EQ(record(), part);

  ASSERT_EQ(study({"--resume", "--methods", kMany[1]}).code, 0);
  const Json whole = record();
  EXPECT_EQ(whole["finished"], true);
  for (std::size_t i = 0; i < 3; ++i) {
    const Json &before = part["methods"][i]["runs"], &after = whole["methods"][i]["runs"];
    ASSERT_LE(before.size(), after.size());
    for (std::size_t k = 0; k < before.size(); ++k) EXPECT_EQ(before[k], after[k]) << "times and all";
  }
}

// It is killed, as after a hanging exercise and a second Ctrl-C. The whole study would take ten seconds.
TEST_F(HairlabStudy, KilledKeepsTheRunsOfBefore) {
  ProgramSettings settings;
  settings.meanwhile = [&](int process) {
    wait_for_a_run(process);
    kill(process, SIGKILL);
  };
  settings.environment = {"XDG_CACHE_HOME=" + (folder_ / "cache").string()};
  const std::string scene = folder_.write("scene.json", kSoftHair);
  const ProgramRun run = run_hairlab({"study", scene, "--out", out_.string()}, settings);
  ASSERT_EQ(run.code, -1) << run.output << run.errors;
  const Json part = record();
  EXPECT_EQ(part["finished"], false);
  ASSERT_FALSE(part["methods"][0]["runs"].empty());
  EXPECT_TRUE(has(bytes_of(out_ / "index.html"), "--resume goes on"));
  expect_refused(study({"--resume"}), 2, "is another study, and can't be resumed: its \"");
  EXPECT_EQ(record(), part);
  for (const std::string& name : folder_.names()) EXPECT_FALSE(name.starts_with(".hairlab-")) << name;
}

TEST_F(HairlabStudy, AnotherProgramCanNotResume) {
  ASSERT_EQ(study(kFew).code, 0);
  const Json before = record();
  const std::string studies = bytes_of(HAIRLAB "-study"), same = folder_.write("same", studies),
                    other = folder_.write("other", studies + "x");
  for (const std::string& program : {same, other}) fs::permissions(program, fs::perms::owner_all);
  const std::vector<std::string> resume = {"--methods", kFew[1], "--resume"};
  EXPECT_EQ(study(resume, {.program = same}).code, 0);
  expect_refused(study(resume, {.program = other}), 2,
                 "the program is another than the one that began this study; ");
  EXPECT_EQ(record()["methods"], before["methods"]);
}

TEST_F(HairlabStudy, ALinkStrandIsStudiedByItsOwnMethodsAndWithoutASpaceError) {
  const std::string scene = folder_.write("links.json", kSoftLinks);
  const ProgramRun run = run_hairlab({"study", scene, "--out", out_.string(), "--quick", "--no-cache"});
  ASSERT_EQ(run.code, 0) << run.errors;
  EXPECT_EQ(run.errors, "");
  const Json json = record();
  EXPECT_EQ(json["finished"], true);
  EXPECT_EQ(json["particles"], kLinks + 1);
  EXPECT_NEAR(json["size"].get<double>(), kLinksLength, 1e-15);
  EXPECT_TRUE(json["space_error"].contains("left_out"));
  std::vector<std::string> methods;
  for (const Json& method : json["methods"]) {
    methods.push_back(method["id"]);
    EXPECT_EQ(method["runs"].back()["ending"], "finished") << method["id"];
  }
  EXPECT_EQ(methods, (std::vector<std::string>{"symplectic-euler", "runge-kutta-4", "implicit-euler"}));
}

TEST_F(HairlabStudy, TheCacheThatItHasByItselfMayBeNone) {
  ProgramSettings none;
  none.environment = {"XDG_CACHE_HOME=" + folder_.write("mine.txt", "")};
  const std::string scene = folder_.write("scene.json", kSoftHair);
  const ProgramRun run = run_hairlab(
      {"study", scene, "--out", out_.string(), "--quick", "--duration", "0.05", "--methods", "runge-kutta-4"},
      none);
  EXPECT_EQ(run.code, 0);
  EXPECT_EQ(run.errors, "");
}

// The refusal comes before the accurate motion is computed, which would be kept in the cache.
TEST_F(HairlabStudy, WhatCanNotBeResumedIsRefusedAtOnce) {
  const auto expect_at_once = [&](const std::vector<std::string>& arguments, const std::string& part) {
    expect_refused(study(arguments), 2, part);
    EXPECT_FALSE(fs::exists(folder_ / "cache")) << part;
  };
  fs::create_directory(out_);
  expect_at_once({"--resume"}, ": there is no earlier study; leave out --resume\n");
  folder_.write("out/study.json", "{\n  \"program\": \"hairlab study\"!");
  expect_at_once({"--resume"}, "study.json: line 2, column 29: not JSON");

  fs::remove_all(out_);
  ASSERT_EQ(study(kFew).code, 0);
  fs::remove_all(folder_ / "cache");
  expect_at_once({"--resume", "--methods", "h6"}, "is another study, and can't be resumed: its \"methods\"");
  Json spoiled = record();
  spoiled["methods"][0]["runs"][0]["seconds"] = Json::array();
  spoiled.erase("program");  // it must come first
  folder_.write("out/study.json", "{\n  \"program\": \"hairlab study\"," + spoiled.dump().substr(1));
  expect_at_once({"--resume", "--methods", kFew[1]}, "seconds: is empty");
}

TEST_F(HairlabStudy, NamesTheExerciseThatAStubIsOf) {
  expect_refused(run_hairlab({"study", folder_.write("links.json", kSoftLinks), "--out", out_.string()},
                             {.program = STUDENT_HAIRLAB}),
                 3, "hairlab: this needs H7: student/rigid_links.cpp, ");
  EXPECT_FALSE(fs::exists(out_));
}

}  // namespace
}  // namespace hair
