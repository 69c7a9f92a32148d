// hairlab stability from outside: how it resumes, and its results for rigid links.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "hair/lab/tests/run_hairlab.h"

namespace hair {
namespace {

using OrderedJson = nlohmann::ordered_json;  // a record is identified by its first keys

class StabilityCommand : public testing::Test {
 protected:
  ProgramRun stability(std::vector<std::string> more = {}, const ProgramSettings& settings = {}) {
    std::vector<std::string> arguments = {
        "stability", "strand-swing", "--quick", "--segments", "2", "--out", (folder_ / "out").string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_hairlab(arguments, settings);
  }
  OrderedJson record() const { return OrderedJson::parse(bytes_of(folder_ / "out/stability.json")); }

  TestFolder folder_;
};

// As after Ctrl-C, some maps exist; their times show that only these are not computed again.
TEST_F(StabilityCommand, ResumedKeepsTheMapsThatAreFinishedAndMakesTheOthers) {
  ASSERT_EQ(stability().code, 0);
  const OrderedJson whole = record();
  OrderedJson part = whole;
  for (const std::size_t gone : {13, 7, 2}) part["maps"].erase(gone);
  for (OrderedJson& map : part["maps"]) map["cpu_seconds"] = 123.0;
  folder_.write("out/stability.json", part.dump(2));
  ASSERT_EQ(stability({"--resume"}).code, 0);
  const OrderedJson again = record();
  ASSERT_EQ(again["maps"].size(), 14u);
  for (std::size_t i = 0; i < 14; ++i) {
    OrderedJson now = again["maps"][i], before = whole["maps"][i];
    const bool made = i == 13 || i == 7 || i == 2;
    EXPECT_EQ(now["cpu_seconds"] == 123.0, !made) << "map " << i;
    now.erase("cpu_seconds");
    before.erase("cpu_seconds");
    EXPECT_EQ(now, before) << "map " << i;
  }

  // It can't resume with other settings, and refuses a damaged record.
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

}  // namespace
}  // namespace hair
