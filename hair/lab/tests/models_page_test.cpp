// The rows and the page of a comparison of models that is made up.
#include <gtest/gtest.h>

#include "hair/lab/models/models_record.h"

namespace hair {
namespace {

using namespace model_study;

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
  return {{one}, {{1, 1e-6, 1e-6}, {2, 2e-6, 4e-6}}};
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
  EXPECT_EQ(model_rows(comparison).size(), 8u);
  EXPECT_EQ(length_rows(comparison).size(), 8u);
  const std::string page = to_html(models_page(comparison));
  for (const char* part : {"blows up after 7 steps", "needs a better &lt;example&gt;", "4 (20, 1/60)"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
}

}  // namespace
}  // namespace hair
