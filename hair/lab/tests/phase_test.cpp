// The phase plane shows each method as theory has it, with the solved exercise; and hairlab writes it.
#include "hair/lab/phase/phase_plane.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "hair/lab/tests/run_hairlab.h"

namespace hair {
namespace {

namespace fs = std::filesystem;

TEST(PhaseCommand, ShowsWhatTheoryHas) {
  const TestFolder folder;
  const fs::path out = folder / "out";
  const ProgramRun done = run_hairlab({"phase", "--out", out.string()});
  ASSERT_EQ(done.code, 0) << done.errors;
  EXPECT_EQ(folder.names("out"), (std::vector<std::string>{"index.html", "phase.csv", "phase.json"}));
  const auto methods = nlohmann::json::parse(bytes_of(out / "phase.json"))["methods"];
  ASSERT_EQ(methods.size(), 4);
  for (const auto& method : methods) EXPECT_EQ(method["evaluations"], method["should_evaluate"]) << method;
  EXPECT_GT(methods[0]["energy"], 2) << "forward Euler winds outwards";
  for (const int kept : {1, 2, 3}) {
    // The swing is larger than small ones, and slower: sin(0.5) / 0.5 = 0.96. So it gains less.
    const double energy = methods[kept]["energy"], should = methods[kept]["should_end"];
    EXPECT_NEAR(energy, should, 0.3) << methods[kept];
  }
  EXPECT_GT(methods[2]["energy"], 1.1) << "midpoint winds outwards, so that one sees it";
  EXPECT_NEAR(methods[3]["energy"], 1, 0.005);
  EXPECT_TRUE(has(bytes_of(out / "index.html"), "id=\"Runge-Kutta-4\""));
}

TEST(PhaseCommand, NamesTheExerciseThatIsNotWritten) {
  const TestFolder folder;
  const ProgramRun done =
      run_hairlab({"phase", "--out", (folder / "out").string()}, {.program = STUDENT_HAIRLAB});
  EXPECT_EQ(done.code, 3) << done.errors;
  EXPECT_TRUE(has(done.errors, "P1: student/explicit_integrators.cpp, forward_euler is not implemented yet"))
      << done.errors;
  EXPECT_TRUE(folder.names().empty());
}

TEST(PhasePage, IsDrawnOfNumbersThatAreNone) {
  phase::Motion motion = {"midpoint", "It winds outwards.", 2, 1, 4, {{0.5, 0}, {std::nan(""), 1e300}}};
  EXPECT_NO_THROW(to_html(phase::phase_page({motion})));
}

}  // namespace
}  // namespace hair
