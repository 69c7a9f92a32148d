// STAFF ONLY. Refinement: few cells tell all, and islands of a size are met.

#include "hair/lab/stability/refine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "hair/lab/stability/tests/never_interrupted.h"

namespace reference_tests {
namespace {

using Classes = std::function<int(int column, int row)>;

constexpr int kSize = 64;

hair::RefinedGrid refined(const Classes& classes) {
  std::vector<int> calls(kSize * kSize, 0);
  hair::RefinedGrid grid = hair::refine(
      kSize, kSize,
      [&](int column, int row) {
        ++calls[static_cast<std::size_t>(row) * kSize + column];
        return classes(column, row);
      },
      kNeverInterrupted);
  EXPECT_TRUE(grid.complete);
  EXPECT_EQ(grid.asked, std::count(calls.begin(), calls.end(), 1)) << "each cell is asked for once at most";
  EXPECT_EQ(*std::max_element(calls.begin(), calls.end()), 1);
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
    return std::count(grid.cells.begin(), grid.cells.end(), 3) > 0;
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
