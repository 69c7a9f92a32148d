// A grid of classes, of which few cells are asked for: those at the boundaries.
//
// Every kCoarse-th column is searched: every kCoarse-th cell is asked for, and between two of different
// classes the boundary is found by halving. A column in the middle of two others has the boundaries that both
// have where theirs are in the mean, or near there: two cells are asked for at least. From the first boundary
// that only one of them has, or that can't be found, it is searched from there up. In the column halfway
// between two searched ones each stretch's ends and middle are asked for as well, and where they say
// otherwise all of it is searched. A column right between two with the same classes, and boundaries at most
// two cells apart, is not asked at all.
//
// So an island that holds a square of kCoarse cells on a side is met. Of that island, and of others, what is
// thinner than that can be missed.
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

// `classify` says the class, >= 0, of (column, row), and is asked once for each cell at most. columns, rows
// >= 2.
RefinedGrid refine(int columns, int rows, const std::function<int(int column, int row)>& classify,
                   const std::atomic<bool>& interrupted);

}  // namespace hair
