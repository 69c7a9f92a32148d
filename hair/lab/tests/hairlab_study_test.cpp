// hairlab study from outside: what it keeps.
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
};

TEST_F(HairlabStudy, KeepsTheAccurateMotion) {
  for (const bool kept : {false, true}) {
    ASSERT_EQ(study({"--methods", "symplectic-euler,runge-kutta-4"}).code, 0);
    EXPECT_EQ(record()["finished"], true);
    EXPECT_EQ(record()["reference"]["from_cache"], kept);
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
  EXPECT_TRUE(has(bytes_of(out_ / "index.html"), "Interrupted: finer steps are missing of "));
}

}  // namespace
}  // namespace hair
