// Fills a grid of classes but evaluates only a few cells: those near the boundaries.
//
// Every kCoarse-th column is searched: every kCoarse-th cell is evaluated, and bisection finds a boundary
// between two cells of different classes. A column in the middle between two others expects each common
// boundary at the mean of theirs, or near it, and evaluates at least two cells to confirm it. From the first
// boundary that only one neighbour has, or that is not found, the rest of the column is searched. The column
// halfway between two searched columns also evaluates the ends and the middle of each stretch; if they
// contradict, the whole column is searched. A column directly between two columns with the same classes, and
// boundaries at most two cells apart, is not evaluated.
//
// So an island that contains a square of kCoarse x kCoarse cells is found. Thinner parts of it, and thinner
// islands, can be missed.
#pragma once

#include <atomic>
#include <functional>
#include <vector>

namespace hair {

inline constexpr int kCoarse = 8;  // cells between evaluated cells

struct RefinedGrid {
  std::vector<int> cells;  // rows of columns: cells[row * columns + column]
  long asked = 0;          // the number of evaluated cells; the others are inferred
  bool complete = false;   // false: interrupted, and the other cells are -1
};

// `classify` returns the class, >= 0, of (column, row); it is called at most once for each cell. columns,
// rows >= 2.
RefinedGrid refine(int columns, int rows, const std::function<int(int column, int row)>& classify,
                   const std::atomic<bool>& interrupted);

}  // namespace hair
