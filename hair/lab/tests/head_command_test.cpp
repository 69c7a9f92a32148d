// hairlab study head from outside: what it writes, what it says, what it returns.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "hair/lab/tests/run_hairlab.h"

namespace hair {
namespace {

using Json = nlohmann::json;

const ProgramSettings kStudentLab{.program = STUDENT_HAIRLAB};

class HairlabHead : public testing::Test {
 protected:
  ProgramRun study(std::vector<std::string> more, const ProgramSettings& settings = {}) {
    std::vector<std::string> arguments = {"study", "head", "--out", out_.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_hairlab(arguments, settings);
  }
  void expect_refused(const ProgramRun& run, int code, const std::string& part) {
    EXPECT_EQ(run.code, code) << run.errors;
    EXPECT_TRUE(has(run.errors, part)) << run.errors;
    EXPECT_EQ(lines_of(run.errors), 1) << run.errors;
    EXPECT_FALSE(std::filesystem::exists(out_));
  }

  TestFolder folder_;
  const std::filesystem::path out_ = folder_ / "out";
};

TEST_F(HairlabHead, WritesPageTableAndRecordAndReplacesThem) {
  const std::vector<std::string> few = {"--hair", "straight",     "--strands", "60", "--exercise-strands",
                                        "60",     "--no-pictures"};
  for (int turn = 0; turn < 2; ++turn) {
    const ProgramRun run = study(few);
    ASSERT_EQ(run.code, 0) << run.errors;
    EXPECT_EQ(run.errors, "") << "progress is for terminals";
    EXPECT_EQ(run.output, (out_ / "index.html").string() + "\n");
  }
  EXPECT_EQ(folder_.names("out"), (std::vector<std::string>{"head.csv", "head.json", "index.html"}));
  const Json json = Json::parse(bytes_of(out_ / "head.json"));
  EXPECT_EQ(json["no_pictures"], "--no-pictures");
  ASSERT_EQ(json["cases"].size(), 2u);
  EXPECT_EQ(json["cases"][0]["head"], true);
  EXPECT_EQ(json["cases"][1]["head"], false);
  for (const Json& one : json["cases"]) {
    EXPECT_EQ(one["strands"], 60);
    ASSERT_EQ(one["runs"].size(), 1u);
    EXPECT_EQ(one["runs"][0]["guides"], 50);
    EXPECT_GT(one["runs"][0]["modes"]["interpolate"]["end"]["rms"], 0);
  }
}

TEST_F(HairlabHead, RefusesWhatIsNotThereInOneLine) {
  expect_refused(study({"--hair", "grey"}), 2,
                 "hairlab: --hair: there is no \"grey\"; there are straight, combed, wavy, curly\n");
  expect_refused(study({"--exercise-strands", "0"}), 2, "--exercise-strands");
  expect_refused(study({"--exercise-strands", "nan"}), 2, "--exercise-strands");
  expect_refused(study({"--threads", "0"}), 2, "--threads");
  expect_refused(study({"--duration", "1"}), 2, "--duration");
  expect_refused(run_hairlab({"study", "head"}), 2, "--out is required");
}

// A study of a scene needs what it needed before it had a command of its own.
TEST_F(HairlabHead, LeavesTheStudyOfScenesAsItIs) {
  expect_refused(run_hairlab({"study"}), 2, "SCENE is required");
  expect_refused(run_hairlab({"study", "pendulum"}), 2, "--out is required");
  expect_refused(run_hairlab({"study", "./head", "--out", out_.string()}), 2, "./head");
}

TEST_F(HairlabHead, RefusesAFolderWithAnythingElse) {
  const std::filesystem::path file = folder_.write("notes.txt", "mine");
  const ProgramRun run = run_hairlab({"study", "head", "--out", folder_.path().string()});
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(lines_of(run.errors), 1) << run.errors;
  EXPECT_EQ(bytes_of(file), "mine");
}

// Stubs: nothing is written. A student's program has no engine, and no option for it.
TEST_F(HairlabHead, NamesTheExerciseThatIsNotWritten) {
  const ProgramRun run =
      study({"--hair", "straight", "--exercise-strands", "60", "--no-pictures"}, kStudentLab);
  expect_refused(run, 3, "hairlab: this needs ");
  expect_refused(study({"--strands", "60"}, kStudentLab), 2, "--strands");
}

}  // namespace
}  // namespace hair
