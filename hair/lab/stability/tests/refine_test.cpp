// STAFF ONLY. Refinement: few cells determine all others, islands above a size are found, and smaller ones
// can be missed.

#include "hair/lab/stability/refine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "hair/lab/stability/tests/never_interrupted.h"

namespace reference_tests {
namespace {

using Classes = std::function<int(int column, int row)>;

constexpr int kSize = 64;

hair::RefinedGrid refined(const Classes& classes, int size = kSize) {
  std::vector<int> calls(static_cast<std::size_t>(size) * size, 0);
  hair::RefinedGrid grid = hair::refine(
      size, size,
      [&](int column, int row) {
        ++calls[static_cast<std::size_t>(row) * size + column];
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
      expect_same_within_a_cell(one, refined(one), what);
      if (HasFatalFailure()) return;
    }
}

TEST(Refine, FindsBoundariesThatCrossTheEdges) {
  for (double slope = -8; slope <= 8; slope += 0.125)
    for (const int at : {-20, 0, 13, 40, 70}) {
      const Classes classes = [&](int column, int row) {
        const double low = at + slope * (column - kSize / 2.0);
        return row < low ? 0 : row < low + 20 ? 1 : 2;
      };
      const std::string what = "slope " + std::to_string(slope) + " through " + std::to_string(at);
      expect_same_within_a_cell(classes, refined(classes), what);
      if (HasFatalFailure()) return;
    }
}

// From one column to the next, a boundary jumps, the class above it changes, and a layer ends.
TEST(Refine, FindsWhatChangesFromOneColumnToTheNext) {
  for (int edge = 1; edge < kSize; ++edge)
    for (int jump = 1; jump <= 12; ++jump) {
      const std::vector<Classes> all = {
          [&](int column, int row) { return row < 20 + (column < edge ? 0 : jump) ? 0 : 1; },
          [&](int column, int row) { return row < 20        ? 0
                                            : column < edge ? 1
                                                            : 2; },
          [&](int column, int row) { return row < 20                           ? 0
                                            : column < edge && row < 20 + jump ? 1
                                                                               : 2; },
          [&](int column, int row) { return row < 20                            ? 0
                                            : column >= edge && row < 20 + jump ? 1
                                                                                : 2; }};
      for (std::size_t k = 0; k < all.size(); ++k) {
        // A layer without a coarse row, which only one of two neighbours has, can be missed.
        if (k >= 2 && jump < hair::kCoarse) continue;
        expect_same_within_a_cell(
            all[k], refined(all[k]),
            std::to_string(k) + ", edge " + std::to_string(edge) + ", jump " + std::to_string(jump));
        if (HasFatalFailure()) return;
      }
    }
}

// The same two classes again and again, in bands that rise and fall, with whole ones at the edges.
TEST(Refine, FindsBandsOfTwoClasses) {
  for (const double steep : {0.5, 1.0, 2.0, 3.0})
    for (const int thick : {8, 9, 12})
      for (const double turn : {0.15, 0.2, 0.3}) {
        const Classes classes = [&](int column, int row) {
          const double band = (row - 20 - std::min(steep / turn, 10.0) * std::sin(turn * column)) / thick;
          return static_cast<int>(std::clamp(std::floor(band), -1.0, 2.0)) & 1;
        };
        expect_same_within_a_cell(classes, refined(classes),
                                  "steep " + std::to_string(steep) + ", turn " + std::to_string(turn) +
                                      ", thick " + std::to_string(thick));
        if (HasFatalFailure()) return;
      }
}

TEST(Refine, AsksForATenthOfTheCellsOfTwoBoundaries) {
  for (const Boundaries& one : many_boundaries(1)) {
    const hair::RefinedGrid grid = refined(one);
    EXPECT_LE(10 * grid.asked, kSize * kSize) << "steep " << one.steep << ", turn " << one.turn;
  }
}

// Above the boundary two classes alternate at random; the boundary below them stays right.
TEST(Refine, ChanceAboveABoundaryLeavesItWhereItIs) {
  for (const Boundaries& one : many_boundaries(2)) {
    std::mt19937 random(7);
    std::vector<int> chance(static_cast<std::size_t>(kSize) * kSize);
    for (int& cell : chance) cell = 1 + static_cast<int>(random() % 2);
    const Classes classes = [&](int column, int row) {
      return one(column, row) == 0 ? 0 : chance[static_cast<std::size_t>(row) * kSize + column];
    };
    const hair::RefinedGrid grid = refined(classes);
    for (int column = 0; column < kSize; ++column) {
      int expected = 0, found = 0;
      while (expected < kSize && one(column, expected) == 0) ++expected;
      while (found < kSize && grid.cells[static_cast<std::size_t>(found) * kSize + column] == 0) ++found;
      ASSERT_LE(std::abs(found - expected), 1) << "column " << column << " of steep " << one.steep;
    }
  }
}

struct Island {
  int column, row, width, height;
  bool has(int c, int r) const { return c >= column && c < column + width && r >= row && r < row + height; }
  Classes in(int sea) const {
    return [*this, sea](int c, int r) { return has(c, r) ? 3 : r < sea ? 0 : 1; };
  }
};

int cells_met(const hair::RefinedGrid& grid) {
  return static_cast<int>(std::count(grid.cells.begin(), grid.cells.end(), 3));
}

TEST(Refine, MeetsEveryIslandOfItsOwnSize) {
  constexpr int kSide = hair::kCoarse;
  for (int column = 0; column + kSide <= kSize; ++column)
    for (int row = 0; row + kSide <= kSize; ++row)
      EXPECT_GT(cells_met(refined(Island{column, row, kSide, kSide}.in(20))), 0) << column << ", " << row;
}

TEST(Refine, FindsTheShoresOfLargerIslands) {
  constexpr int kSide = 3 * hair::kCoarse;
  for (int column = 0; column + kSide <= kSize; column += 5)
    for (int row = 0; row + kSide <= kSize; row += 3) {
      const Island island{column, row, kSide, kSide};
      const Classes classes = island.in(20);
      const hair::RefinedGrid grid = refined(classes);
      expect_same_within_a_cell(classes, grid,
                                "island at " + std::to_string(column) + ", " + std::to_string(row));
      if (HasFatalFailure()) return;
    }
}

// As the header says, an island without a square of the stride can be missed. This one lies between all
// evaluated cells.
TEST(Refine, MissesAnIslandBesideTheCellsThatItAsksFor) {
  const Island island{hair::kCoarse + 1, 33, hair::kCoarse - 1, hair::kCoarse - 1};
  EXPECT_EQ(cells_met(refined(island.in(20))), 0);
}

// A narrow island between two searched columns is found if it is as high as half of a stretch, or at an edge.
TEST(Refine, MeetsNarrowIslandsHalfwayBetweenItsColumns) {
  for (int between = 0; between + hair::kCoarse < kSize; between += hair::kCoarse) {
    const int column = between + hair::kCoarse / 2 - 1;
    for (const Island& island : {Island{column, 25, 3, 22}, {column, 0, 3, 4}, {column, kSize - 4, 3, 4}})
      EXPECT_GT(cells_met(refined(island.in(20))), 0) << "column " << column << ", row " << island.row;
  }
}

// An island of a third class in the search for a boundary: at the search's first cell, and in its last
// bisection.
TEST(Refine, MeetsNarrowIslandsWhereABoundaryShouldBe) {
  for (int between = 0; between + hair::kCoarse < kSize; between += hair::kCoarse) {
    EXPECT_GT(cells_met(refined(Island{between + 2, 20, 1, 1}.in(20))), 0) << "after column " << between;
    const Island later{between + 2, 24, 1, 3};
    const Classes classes = [&](int column, int row) {
      const bool beside = column != later.column;
      return later.has(column, row) ? 3 : row < (beside ? 20 : later.row) ? 0 : 1;
    };
    EXPECT_GT(cells_met(refined(classes)), 0) << "after column " << between;
  }
}

TEST(Refine, AnInterruptedGridSaysSo) {
  std::atomic<bool> interrupted = false;
  long calls = 0;
  const hair::RefinedGrid grid = hair::refine(
      16, 16, [&](int, int) { return interrupted = ++calls == 5, 0; }, interrupted);
  EXPECT_FALSE(grid.complete);
  EXPECT_EQ(calls, 5);
}

TEST(Refine, GridsOfAnySizeAreFilled) {
  for (const int size : {2, 3, 7, 8, 9, 10, 17}) {
    const hair::RefinedGrid grid = refined([](int column, int row) { return row > column ? 1 : 0; }, size);
    EXPECT_EQ(std::count(grid.cells.begin(), grid.cells.end(), -1), 0) << size;
  }
}

}  // namespace
}  // namespace reference_tests
