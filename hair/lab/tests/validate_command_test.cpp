// hairlab validate from outside: what it writes, what it says, what it returns.
#include <gtest/gtest.h>
#include <signal.h>

#include <nlohmann/json.hpp>

#include "hair/lab/tests/run_hairlab.h"

namespace hair {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const ProgramSettings kStudent{.program = STUDENT_HAIRLAB};

TEST(ValidateCommand, ListsWhatThereIs) {
  const ProgramRun run = run_hairlab({"validate", "--list"});
  EXPECT_EQ(run.code, 0) << run.errors;
  EXPECT_TRUE(has(run.output, "published-numbers: ")) << run.output;
  EXPECT_TRUE(has(run.output, "(no exercise)")) << run.output;
  EXPECT_TRUE(has(run.output, "chain-h6: ") && has(run.output, "(S1, H1, H4, H5, H6)")) << run.output;
}

TEST(ValidateCommand, LeavesOutWhatCallsExercisesThatTheCourseLeavesOut) {
  const TestFolder folder;
  const ProgramRun run =
      run_hairlab({"validate", "--list", "--course",
                   folder.write("course.json", R"({"exercises": {"H6": {"role": "absent"}}})")});
  EXPECT_EQ(run.code, 0) << run.errors;
  EXPECT_TRUE(has(run.output, "published-numbers: ") && !has(run.output, "H6")) << run.output;
}

TEST(ValidateCommand, RunsThoseThatAreAskedForInTheListsOrder) {
  const ProgramRun run = run_hairlab({"validate", "pendulum-rods", "published-numbers"});
  EXPECT_EQ(run.code, 0) << run.errors;
  EXPECT_EQ(run.errors, "") << "progress is for terminals";
  EXPECT_LT(run.output.find("published-numbers: "), run.output.find("pendulum-rods: ")) << run.output;
  EXPECT_FALSE(has(run.output, "chain-h6")) << run.output;
  EXPECT_TRUE(has(run.output, "14 of 14 checks hold\n")) << run.output;
}

TEST(ValidateCommand, WritesPageTableAndJson) {
  const TestFolder folder;
  const std::vector<std::string> arguments = {"validate", "pendulum-rods", "--quick", "--out",
                                              (folder / "out").string()};
  ASSERT_EQ(run_hairlab(arguments).code, 0);
  EXPECT_EQ(folder.names("out"), (std::vector<std::string>{"index.html", "validate.csv", "validate.json"}));
  const std::string text = bytes_of(folder / "out/validate.json");
  const Json json = Json::parse(text);
  EXPECT_EQ(json["quick"], true);
  ASSERT_EQ(json["validations"].size(), 1u);
  const std::size_t checks = json["validations"][0]["checks"].size();
  EXPECT_EQ(lines_of(bytes_of(folder / "out/validate.csv")), static_cast<std::ptrdiff_t>(checks) + 1);
  EXPECT_TRUE(has(bytes_of(folder / "out/index.html"), "<svg"));

  // Again, over what is there: the same, but for the time.
  ASSERT_EQ(run_hairlab(arguments).code, 0);
  Json again = Json::parse(bytes_of(folder / "out/validate.json")), before = json;
  for (Json* one : {&again, &before}) (*one)["validations"][0].erase("cpu_seconds");
  EXPECT_EQ(again, before);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"out"});
}

TEST(ValidateCommand, RefusesWhatItDoesNotKnow) {
  const ProgramRun unknown = run_hairlab({"validate", "pendulum"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_TRUE(has(unknown.errors, "there is no validation \"pendulum\"; there are published-numbers, "))
      << unknown.errors;
  EXPECT_EQ(lines_of(unknown.errors), 1) << unknown.errors;
  EXPECT_EQ(run_hairlab({"validate", "--fast"}).code, 2);

  const TestFolder folder;
  fs::create_directory(folder / "out");
  folder.write("out/letter.txt", "dear");
  const ProgramRun foreign =
      run_hairlab({"validate", "published-numbers", "--out", (folder / "out").string()});
  EXPECT_EQ(foreign.code, 2);
  EXPECT_EQ(lines_of(foreign.errors), 1) << foreign.errors;
  EXPECT_EQ(foreign.output, "") << "before it computes";
  EXPECT_EQ(bytes_of(folder / "out/letter.txt"), "dear");
}

TEST(ValidateCommand, SaysWhatIsNotWrittenYet) {
  const ProgramRun one = run_hairlab({"validate", "chain-rods"}, kStudent);
  EXPECT_EQ(one.code, 3);
  EXPECT_TRUE(has(one.errors, "hairlab: this needs P1: student/explicit_integrators.cpp, ")) << one.errors;

  // What calls no exercise can run, and is not why anyone asks.
  const ProgramRun all = run_hairlab({"validate", "--quick"}, kStudent);
  EXPECT_EQ(all.code, 3);
  EXPECT_TRUE(has(all.output, "left out: it needs P1: student/explicit_integrators.cpp, ")) << all.output;

  const ProgramRun numbers = run_hairlab({"validate", "published-numbers"}, kStudent);
  EXPECT_EQ(numbers.code, 0) << numbers.errors;
}

TEST(ValidateCommand, KeepsWhatIsFinishedWhenItIsInterrupted) {
  const TestFolder folder;
  ProgramSettings settings;
  settings.meanwhile = [&](int process) {
    const fs::path hidden = folder / (".hairlab-out-" + std::to_string(process));
    EXPECT_TRUE(wait_until([&] { return fs::exists(hidden); }, process));
    kill(process, SIGINT);
  };
  const ProgramRun run = run_hairlab({"validate", "--out", (folder / "out").string()}, settings);
  EXPECT_EQ(run.code, 130) << run.errors;
  EXPECT_TRUE(has(run.errors, "interrupted after ")) << run.errors;
  const Json json = Json::parse(bytes_of(folder / "out/validate.json"));
  EXPECT_GE(json["validations"].size(), 1u);
}

}  // namespace
}  // namespace hair
