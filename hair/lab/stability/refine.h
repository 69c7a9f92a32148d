// Fills a grid of classes but evaluates only a few cells: those near the boundaries.
//
// In every second column every kCoarse-th cell is evaluated, and a boundary between two cells of different
// classes is found by bisection. A column between two with the same classes, and boundaries at most two cells
// apart, has its boundaries at their means; any other column is searched as well.
//
// So an island that is two columns wide and kCoarse cells high is found. Smaller ones can be missed.
#pragma once

#include <atomic>
#include <functional>
#include <vector>

namespace hair {

inline constexpr int kCoarse = 8;  // cells between evaluated cells

struct RefinedGrid {
  std::vector<int> cells;  // rows of columns: cells[row * columns + column]
  long asked = 0;          // the number of evaluated cells; the others are inferred
  bool complete = false;   // false: interrupted, and all cells are -1
};

// `classify` returns the class, >= 0, of (column, row); it is called at most once for each cell. columns,
// rows >= 2.
RefinedGrid refine(int columns, int rows, const std::function<int(int column, int row)>& classify,
                   const std::atomic<bool>& interrupted);

}  // namespace hair
