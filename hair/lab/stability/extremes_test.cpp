// STAFF ONLY. Extreme cases are as their names say, and each method has its necessary outcome. Refinement
// asks few cells, and meets islands of a size.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "hair/io/files/bad_input.h"
#include "hair/lab/stability/extremes.h"
#include "hair/lab/stability/maps.h"
#include "hair/lab/stability/refine.h"
#include "hair/lab/stability/theory.h"
#include "hair/simulation/test_hairs.h"
#include "hair/strand/measures.h"

namespace reference_tests {
namespace {

using Classes = std::function<int(int column, int row)>;

Description falling_hair() {
  Description description = alone(straight_hair(4, 0.04), Method::implicit_euler, 1e-3);
  description.gravity = kG * kDown;
  return description;
}

TEST(Extremes, AreWhatTheirNamesSay) {
  const std::vector<hair::ExtremeCase> cases = hair::extreme_cases(falling_hair());
  ASSERT_EQ(cases.size(), 8u);
  const auto of = [&](const std::string& name) {
    const auto found =
        std::ranges::find_if(cases, [&](const hair::ExtremeCase& one) { return one.name == name; });
    EXPECT_NE(found, cases.end()) << name;
    return found->start;
  };
  const auto tip_height = [](const StrandStart& start) { return start.state.x[start.state.x.size() - 1]; };
  EXPECT_NEAR(tip_height(of("held level")), 0, 1e-15);
  EXPECT_NEAR(of("folded").state.x.tail<3>().norm(), 0, 1e-15);  // four segments, to and fro
  EXPECT_NEAR(tip_height(of("crushed to a hundredth")), -0.04 / 100, 1e-12);
  EXPECT_NEAR(
      hair::largest_stretch(of("torn to thrice its length").strand, of("torn to thrice its length").state.x),
      2, 1e-9);
  EXPECT_NEAR(of("its root flung at 30 m/s").state.v.head<3>().norm(), 30, 1e-12);
  const hair::Strand plain = of("held level").strand, heavy = of("a tip of 1e6 times its mass").strand;
  EXPECT_NEAR(heavy.mass[4] / plain.mass[4], 1e6, 1e-3);
  EXPECT_NEAR(of("EA 1e6 times as large").strand.stretch_rigidity / plain.stretch_rigidity, 1e6, 1e-3);
}

// A case without forces stays at rest, and shows nothing about a method.
TEST(Extremes, LeaveOutWithoutGravityWhatWouldNotMove) {
  Description floating = falling_hair();
  floating.gravity.setZero();
  floating.strands[0].strand.clamped = true;
  std::vector<std::string> names;
  for (const hair::ExtremeCase& one : hair::extreme_cases(floating)) names.push_back(one.name);
  EXPECT_EQ(names, (std::vector<std::string>{"folded", "crushed to a hundredth", "torn to thrice its length",
                                             "its root flung at 30 m/s"}));
  // A thread without weight and without bending has no oscillation across itself at all.
  Description thread = floating;
  thread.strands[0].strand.bend_rigidity = 0;
  EXPECT_THROW(hair::hang(thread, 1, false), hair::BadInput);
  Description loose = floating;
  loose.strands[0].strand.clamped = false;
  EXPECT_THROW(hair::hang(loose, 1, false), hair::BadInput);
}

// Midpoint has no limit of its own without drag; its step is half of RK4's.
TEST(Extremes, AnExplicitMethodBreaksAtCommonStepsAndNotBelowItsLimit) {
  for (const auto& [which, limit_of, from] :
       {std::tuple{Method::symplectic_euler, Method::symplectic_euler, "half its limit"},
        {Method::midpoint, Method::runge_kutta_4, "half of RK4's limit"}}) {
    hair::StudyMethod method;
    method.method = which;
    const double fastest = hair::hang(hair::with_options(falling_hair(), method), 1, false).fastest();
    const std::vector<hair::ExtremeRun> runs = hair::run_extremes(falling_hair(), method, false);
    ASSERT_EQ(runs.size(), 3 * 8u);
    for (const hair::ExtremeRun& run : runs) {
      EXPECT_EQ(run.step_from, run.h < 1e-3 ? from : "");
      if (run.step_from.empty()) {
        EXPECT_EQ(run.fate, hair::Fate::blown_up) << run.extreme << ", h " << run.h;
      } else if (run.extreme == "held level") {
        EXPECT_NEAR(run.h, hair::explicit_limit(limit_of, {fastest}) / 2, 1e-6 * run.h);
        if (which == Method::symplectic_euler) {
          EXPECT_EQ(run.fate, hair::Fate::stable);
        }
      }
    }
  }
  const std::atomic<bool> interrupted = true;
  EXPECT_TRUE(hair::run_extremes(falling_hair(), {}, interrupted).empty());
}

constexpr int kSize = 64;

hair::RefinedGrid refined(const Classes& classes) {
  std::vector<int> calls(kSize * kSize, 0);
  hair::RefinedGrid grid = hair::refine(
      kSize, kSize,
      [&](int column, int row) {
        ++calls[static_cast<std::size_t>(row) * kSize + column];
        return classes(column, row);
      },
      false);
  EXPECT_TRUE(grid.complete);
  EXPECT_EQ(grid.asked, std::ranges::count(calls, 1)) << "each cell is asked for once at most";
  EXPECT_EQ(*std::ranges::max_element(calls), 1);
  return grid;
}

// Every cell has the class of the full grid, there or in the cell above or below.
void expect_same_within_a_cell(const Classes& classes, const hair::RefinedGrid& grid,
                               const std::string& what) {
  for (int column = 0; column < kSize; ++column)
    for (int row = 0; row < kSize; ++row) {
      const int found = grid.cells[static_cast<std::size_t>(row) * kSize + column];
      bool there = false;
      for (int at = std::max(row - 1, 0); at <= std::min(row + 1, kSize - 1); ++at)
        there = there || found == classes(column, at);
      ASSERT_TRUE(there) << what << ": column " << column << ", row " << row << " is " << classes(column, row)
                         << ", found " << found;
    }
}

// Boundaries that rise and fall by `steep` cells a column at most, 12 cells apart at least, and away from the
// edges: one that dips below an edge for a few columns leaves an island there.
struct Boundaries {
  double steep, turn, bend, between;
  int operator()(int column, int row) const {
    const double low = 16 + std::min(steep / turn, 12.0) * std::sin(turn * column + bend);
    const double high = low + 12 + between * (1 + std::sin(0.5 * turn * column));
    return row < low ? 0 : row < high ? 1 : 2;
  }
};

std::vector<Boundaries> many_boundaries(double steep) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(0, 1);
  std::vector<Boundaries> all;
  for (int k = 0; k < 100; ++k) {
    const double turn = 0.05 + 0.25 * part(random);
    all.push_back({steep * part(random), turn, 6 * part(random), 8 * part(random)});
  }
  return all;
}

TEST(Refine, FindsBoundariesThatBend) {
  for (const double steep : {0.5, 1.0, 2.0, 4.0})
    for (const Boundaries& one : many_boundaries(steep)) {
      const std::string what = "steep " + std::to_string(one.steep) + ", turn " + std::to_string(one.turn) +
                               ", bend " + std::to_string(one.bend);
      const hair::RefinedGrid grid = refined(one);
      expect_same_within_a_cell(one, grid, what);
      if (HasFatalFailure()) return;
      // An even column asks for 9 cells and halves 8 of them twice; the others are few where it is not steep.
      if (steep <= 1) {
        EXPECT_LE(5 * grid.asked, kSize * kSize) << what;
      }
    }
}

TEST(Refine, MeetsEveryIslandThatIsTwoColumnsWideAndAsHighAsItsStride) {
  const auto is_met = [](int column, int row, int width, int height) {
    const hair::RefinedGrid grid = refined([&](int c, int r) {
      return c >= column && c < column + width && r >= row && r < row + height ? 3 : r < 20 ? 0 : 1;
    });
    return std::ranges::count(grid.cells, 3) > 0;
  };
  for (int column = 0; column + 2 <= kSize; ++column)
    for (int row = 0; row + hair::kCoarse <= kSize; ++row)
      EXPECT_TRUE(is_met(column, row, 2, hair::kCoarse)) << column << ", " << row;
  EXPECT_FALSE(is_met(1, 33, 1, hair::kCoarse)) << "as the header says";
  EXPECT_FALSE(is_met(2, 33, 9, hair::kCoarse - 1));
}

TEST(Refine, AnInterruptedGridSaysSo) {
  std::atomic<bool> interrupted = false;
  long calls = 0;
  const hair::RefinedGrid grid = hair::refine(
      16, 16, [&](int, int) { return interrupted = ++calls == 5, 0; }, interrupted);
  EXPECT_FALSE(grid.complete);
  EXPECT_EQ(calls, 5);
}

}  // namespace
}  // namespace reference_tests
