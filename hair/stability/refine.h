// A grid of classes, of which few cells are asked for: those at the boundaries.
//
// Some columns are looked at coarsely, and between two cells of different classes the boundary is found by halving.
// A column in the middle of two others with the same classes in the same order has its boundaries where theirs are in
// the mean: two cells there are asked for, and each stretch's ends and middle; only if they say otherwise it is searched
// coarsely, too. Where the two columns right beside it have boundaries at most two cells apart, it is not asked at all.
//
// What it can miss: what is thinner than kCoarse cells in a column, and has no counterpart in its neighbours (an
// island); in a column that is followed, what lies between a stretch's ends and its middle; and in a column that is not
// asked all that its neighbours, one to the left and one to the right, don't have.
#pragma once

#include <atomic>
#include <functional>
#include <vector>

namespace hair {

inline constexpr int kCoarse = 8;  // cells from one that is looked at to the next

struct RefinedGrid {
  std::vector<int> cells;  // rows of columns: cells[row * columns + column]
  long asked = 0;          // cells that were asked for; the others follow
  bool complete = false;   // false: interrupted, and the rest is -1
};

// `classify` says the class, >= 0, of (column, row), and is asked once for each cell at most. columns, rows >= 2.
RefinedGrid refine(int columns, int rows, const std::function<int(int column, int row)>& classify,
                   const std::atomic<bool>& interrupted);

}  // namespace hair
