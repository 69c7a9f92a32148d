// hairlab stability from outside: what it writes, what it says, how it goes on.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "hair/lab/tests/run_hairlab.h"

namespace hair {
namespace {

using OrderedJson = nlohmann::ordered_json;  // a record is known by how it begins

class StabilityCommand : public testing::Test {
 protected:
  ProgramRun stability(std::vector<std::string> more = {}, const ProgramSettings& settings = {}) {
    std::vector<std::string> arguments = {
        "stability", "strand-swing", "--quick", "--segments", "2", "--out", (folder_ / "out").string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_hairlab(arguments, settings);
  }
  OrderedJson record() const { return OrderedJson::parse(bytes_of(folder_ / "out/stability.json")); }
  void expect_refused(const ProgramRun& run, int code, const std::string& part) {
    EXPECT_EQ(run.code, code) << run.errors;
    EXPECT_TRUE(has(run.errors, part)) << run.errors;
    EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
  }

  TestFolder folder_;
};

TEST_F(StabilityCommand, WritesRecordTablesAndPage) {
  const ProgramRun run = stability();
  ASSERT_EQ(run.code, 0) << run.errors;
  EXPECT_EQ(run.errors, "") << "progress is for terminals";
  EXPECT_TRUE(has(run.output, "index.html: 16 maps, 224 extreme cases\n")) << run.output;
  EXPECT_EQ(folder_.names("out"), (std::vector<std::string>{"boundaries.csv", "curves.csv", "extremes.csv",
                                                            "index.html", "stability.json"}));
  const OrderedJson json = record();
  EXPECT_EQ(json["ended"], "finished");
  ASSERT_EQ(json["maps"].size(), 16u);
  for (const OrderedJson& map : json["maps"]) {
    ASSERT_EQ(map["rows"].size(), map["h"].size());
    for (const OrderedJson& row : map["rows"]) EXPECT_EQ(row.get<std::string>().size(), map["x"].size());
  }
  EXPECT_TRUE(has(bytes_of(folder_ / "out/index.html"), "<svg"));
}

// As after Ctrl-C: some maps are there, and those only are not run anew, as their times show.
TEST_F(StabilityCommand, ResumedKeepsTheMapsThatAreFinishedAndMakesTheOthers) {
  ASSERT_EQ(stability().code, 0);
  const OrderedJson whole = record();
  OrderedJson part = whole;
  for (const std::size_t gone : {15, 7, 2}) part["maps"].erase(gone);
  for (OrderedJson& map : part["maps"]) map["cpu_seconds"] = 123.0;
  folder_.write("out/stability.json", part.dump(2));
  ASSERT_EQ(stability({"--resume"}).code, 0);
  const OrderedJson again = record();
  ASSERT_EQ(again["maps"].size(), 16u);
  for (std::size_t i = 0; i < 16; ++i) {
    OrderedJson now = again["maps"][i], before = whole["maps"][i];
    const bool made = i == 15 || i == 7 || i == 2;
    EXPECT_EQ(now["cpu_seconds"] == 123.0, !made) << "map " << i;
    now.erase("cpu_seconds");
    before.erase("cpu_seconds");
    EXPECT_EQ(now, before) << "map " << i;
  }

  // Of other settings it can't, and a record that was spoiled is refused.
  expect_refused(run_hairlab({"stability", "strand-swing", "--quick", "--segments", "3", "--resume", "--out",
                              (folder_ / "out").string()}),
                 2, "can't be resumed: its hair");
  OrderedJson spoiled = whole;
  spoiled["maps"][3]["rows"][5] = "0123";
  folder_.write("out/stability.json", spoiled.dump(2));
  expect_refused(stability({"--resume"}), 2, "maps[3].rows: are not as many cells");
  spoiled = whole;
  spoiled["maps"][3] = whole["maps"][2];
  folder_.write("out/stability.json", spoiled.dump(2));
  expect_refused(stability({"--resume"}), 2, "maps[3]: is there twice; ");
  spoiled = whole;
  spoiled["maps"][3]["limits"][0].erase("name");
  folder_.write("out/stability.json", spoiled.dump(2));
  expect_refused(stability({"--resume"}), 2, "maps[3].limits[0]: \"name\" is missing");
}

// Whole it takes 20 seconds.
TEST_F(StabilityCommand, InterruptedKeepsWhatIsFinished) {
  ProgramSettings settings;
  settings.meanwhile = [&](int process) {
    // As soon as it studies, its hidden folder is there. In a second it finishes some maps, or none on a slow machine.
    const std::filesystem::path studying = folder_ / (".hairlab-out-" + std::to_string(process));
    EXPECT_TRUE(wait_until([&] { return std::filesystem::exists(studying); }, process));
    std::this_thread::sleep_for(std::chrono::seconds(1));
    kill(process, SIGINT);
  };
  const ProgramRun run =
      run_hairlab({"stability", "strand-swing", "--out", (folder_ / "out").string()}, settings);
  ASSERT_EQ(run.code, 130) << run.output << run.errors;
  if (has(run.errors, "interrupted before a map was finished; nothing is written")) {
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
    return;
  }
  EXPECT_TRUE(has(run.errors, " of 16 maps, which are kept; --resume goes on\n")) << run.errors;
  EXPECT_EQ(record()["ended"], "interrupted");
  EXPECT_FALSE(record()["maps"].empty());
  EXPECT_TRUE(has(bytes_of(folder_ / "out/index.html"), "--resume goes on"));
}

TEST_F(StabilityCommand, BadInputIsRefusedInOneLineAndNothingIsWritten) {
  const std::filesystem::path deep = folder_ / "q/r/s";
  expect_refused(run_hairlab({"stability", "strand-swing", "--out", deep.string(), "--resume"}), 2,
                 deep.string() + ": there is no earlier study; leave out --resume\n");
  EXPECT_TRUE(folder_.names().empty());
  expect_refused(stability({"--strand", "1"}), 2, "there is no strand 1");
  const std::string floating = folder_.write("floating.json", R"({"shows": "hair without weight", "frames": 3,
 "gravity": [0, 0, 0], "hair": [{"segments": 3, "length": 0.1, "clamped": false,
 "roots": {"list": [{"position": [0, 0, 0], "direction": [1, 0, 0]}]}}]})");
  expect_refused(run_hairlab({"stability", floating, "--out", (folder_ / "out").string()}), 2,
                 "nothing brings its strand back when it swings");
  const std::string hinged = folder_.write("hinged.json", R"({"shows": "links at a hinge", "frames": 3,
 "method": "implicit_euler", "hair": [{"model": "rigid_links", "segments": 3, "length": 0.1, "clamped": false,
 "roots": {"list": [{"position": [0, 0, 0], "direction": [1, 0, 0]}]}}]})");
  expect_refused(run_hairlab({"stability", hinged, "--out", (folder_ / "out").string()}), 2,
                 "nothing brings its strand back when it turns about itself; clamp it");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

TEST_F(StabilityCommand, RigidLinksHaveMapsOfTheirOwnMethodsAndNoExtremeCases) {
  const std::vector<std::string> links = {
      "stability", "rigid-links", "--quick", "--segments", "2", "--out", (folder_ / "out").string()};
  const ProgramRun run = run_hairlab(links);
  ASSERT_EQ(run.code, 0) << run.errors;
  EXPECT_TRUE(has(run.output, "index.html: 6 maps, 0 extreme cases\n")) << run.output;
  const OrderedJson json = record();
  EXPECT_GT(json["hair"]["GJ"], 0);
  EXPECT_GT(json["frequencies"]["twist"], json["frequencies"]["across"]);
  std::vector<std::string> methods;
  for (const OrderedJson& map : json["maps"]) methods.push_back(map["method"]);
  EXPECT_EQ(methods, (std::vector<std::string>{"symplectic-euler", "symplectic-euler", "runge-kutta-4",
                                               "runge-kutta-4", "implicit-euler", "implicit-euler"}));
  std::vector<std::string> again = links;
  again.push_back("--resume");
  EXPECT_EQ(run_hairlab(again).code, 0);

  const ProgramRun stub = run_hairlab(links, {.program = STUDENT_HAIRLAB});
  EXPECT_EQ(stub.code, 3) << stub.errors;
  EXPECT_TRUE(has(stub.errors, "RK4 is left out: it needs H7: student/rigid_links.cpp")) << stub.errors;
}

TEST_F(StabilityCommand, NamesTheExercisesThatStubsAreOf) {
  const ProgramRun run = stability({}, {.program = STUDENT_HAIRLAB});
  EXPECT_EQ(run.code, 3) << run.errors;
  EXPECT_TRUE(has(run.errors, "is left out: it needs H1: student/stretch_springs.cpp")) << run.errors;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

}  // namespace
}  // namespace hair
