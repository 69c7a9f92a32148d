// hairlab models: its parts, and the command from outside.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "hair/lab/models/models_page.h"
#include "hair/lab/tests/run_hairlab.h"

namespace hair {
namespace {

using namespace model_study;
using Json = nlohmann::json;

ModelRun made_run(int elements, double error, double seconds) {
  ModelRun run;
  run.elements = elements;
  run.step = 1.0 / 60;
  run.error = error;
  run.seconds = seconds;
  run.lengths = {1.5, 1.25};
  return run;
}

Comparison made_comparison() {
  HairComparison one;
  one.hair = compared_hairs(true)[0];
  one.uncertainty = 1e-5;
  FamilyRuns runs{
      families()[0], {made_run(5, 1e-2, 1e-3), made_run(10, 2e-2, 2e-3), made_run(20, 1e-3, 4e-3)}, ""};
  runs.runs.push_back(made_run(40, 0, 3e-3));
  runs.runs.back().trouble = "blows up after 7 steps";
  one.families = {runs, {families()[1], {}, "needs a better <example>"}};
  one.stiff = {runs};
  return {true, {one}, {{1, 1e-6, 1e-6}, {2, 2e-6, 4e-6}}};
}

TEST(ModelStudy, TheBestRunsAreBeatenByNoOther) {
  const Comparison comparison = made_comparison();
  const auto best = best_of(comparison.hairs[0].families[0]);
  ASSERT_EQ(best.size(), 2u);
  EXPECT_EQ(best[0]->elements, 5);
  EXPECT_EQ(best[1]->elements, 20);
}

TEST(ModelStudy, TablesAndPageHaveAllRunsAndWhatIsLeftOut) {
  const Comparison comparison = made_comparison();
  EXPECT_EQ(table_of_runs(comparison).rows.size(), 8u);
  EXPECT_EQ(table_of_lengths(comparison).rows.size(), 8u);
  const std::string page = to_html(models_page(comparison, "a machine"));
  for (const char* part :
       {"blows up after 7 steps", "needs a better &lt;example&gt;", "a machine", "4 (20, 1/60)"})
    EXPECT_TRUE(has(page, part)) << part;
}

class HairlabModels : public testing::Test {
 protected:
  ProgramRun models(std::vector<std::string> more, const ProgramSettings& settings = {}) {
    std::vector<std::string> arguments = {"models", "--out", out_.string(), "--quick"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_hairlab(arguments, settings);
  }
  TestFolder folder_;
  const std::filesystem::path out_ = folder_ / "out";
};

TEST_F(HairlabModels, RefusesWhatIsNotThereInOneLine) {
  const ProgramRun run = models({"--hair", "grey"});
  EXPECT_EQ(run.code, 2);
  EXPECT_EQ(run.errors,
            "hairlab: --hair: there is no \"grey\"; there are straight, wavy, curly, uncoiling\n");
  EXPECT_FALSE(std::filesystem::exists(out_));
}

// The finest of each family are near the fine motion, and links and helices near each other.
TEST_F(HairlabModels, ModelsAgreeOnStraightHair) {
  const ProgramRun run = models({"--hair", "straight"});
  ASSERT_EQ(run.code, 0) << run.errors;
  EXPECT_EQ(run.output, (out_ / "index.html").string() + "\n");
  EXPECT_EQ(folder_.names("out"),
            (std::vector<std::string>{"index.html", "lengths.csv", "models.csv", "models.json"}));
  const Json json = Json::parse(bytes_of(out_ / "models.json"));
  ASSERT_EQ(json["hairs"].size(), 1u);
  const Json& hair = json["hairs"][0];
  EXPECT_LT(hair["uncertainty"], 2e-4);
  for (const Json& family : hair["families"]) {
    EXPECT_TRUE(family["left_out"].is_null()) << family["family"];
    if (family["family"] == "springs-h4") continue;  // its stretch: centimetres at these steps
    double best = 1;
    for (const Json& one : family["runs"])
      if (one["trouble"].is_null()) best = std::min(best, one["error"].get<double>());
    EXPECT_LT(best, 0.005) << family["family"];
  }
  // At a sixtieth of a second hair's own springs let it stretch, and links don't.
  for (const Json& family : hair["at_a_sixtieth"]) {
    double longest = 0;
    for (const Json& one : family["runs"])
      for (const double length : one["lengths"]) longest = std::max(longest, length);
    if (family["family"] == "springs-1") {
      EXPECT_GT(longest, 1.001);
    }
    if (family["family"] == "links") {
      EXPECT_LT(longest, 1 + 1e-12);
    }
  }
}

TEST_F(HairlabModels, NamesTheExerciseThatIsNotWritten) {
  const ProgramRun run = models({"--hair", "straight"}, {.program = STUDENT_HAIRLAB});
  EXPECT_EQ(run.code, 3);
  EXPECT_TRUE(has(run.errors, "H7")) << run.errors;
  EXPECT_FALSE(std::filesystem::exists(out_));
}

}  // namespace
}  // namespace hair
