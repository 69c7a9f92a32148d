#include "hair/lab/stability/refine.h"

#include <algorithm>
#include <cstdlib>
#include <map>

#include "particles/require.h"

namespace hair {

namespace {

// A stretch of a column: its class, and its first row. Stretches go from the lowest row up.
struct Stretch {
  int fate, begin;
};
using Column = std::vector<Stretch>;

bool are_near(const Column& a, const Column& b) {
  return std::ranges::equal(a, b, [](const Stretch& s, const Stretch& t) {
    return s.fate == t.fate && std::abs(s.begin - t.begin) <= 2;
  });
}

}  // namespace

RefinedGrid refine(int columns, int rows, const std::function<int(int column, int row)>& classify,
                   const std::atomic<bool>& interrupted) {
  particles::require_at_least("the columns of a grid", columns, 2);
  particles::require_at_least("the rows of a grid", rows, 2);
  RefinedGrid grid{std::vector<int>(static_cast<std::size_t>(columns) * rows, -1), 0, true};

  const auto search = [&](int column) {
    std::map<int, int> known;  // the classes of rows
    const auto ask = [&](int row) {
      const auto [place, is_new] = known.try_emplace(row, -1);
      if (is_new && !interrupted) {
        place->second = classify(column, row);
        ++grid.asked;
      }
      return place->second;
    };
    Column result = {{ask(0), 0}};
    for (int low = 0; low < rows - 1;) {
      const int high = std::min(low + kCoarse, rows - 1);
      // There may be more than two classes from low to high.
      while (ask(high) != result.back().fate) {
        int below = std::max(low, result.back().begin), above = high;
        while (above - below > 1) {
          const int middle = (below + above) / 2;
          (ask(middle) == result.back().fate ? below : above) = middle;
        }
        result.push_back({ask(above), above});
      }
      low = high;
    }
    return result;
  };

  std::vector<Column> all(static_cast<std::size_t>(columns));
  for (const int first : {0, 1})
    for (int column = first; column < columns && !interrupted; column += 2) {
      const bool between = first == 1 && column + 1 < columns;
      if (between && are_near(all[column - 1], all[column + 1])) {
        all[column] = all[column - 1];
        for (std::size_t k = 0; k < all[column].size(); ++k)
          all[column][k].begin = (all[column][k].begin + all[column + 1][k].begin) / 2;
      } else {
        all[column] = search(column);
      }
    }
  grid.complete = !interrupted;
  if (!grid.complete) return grid;
  for (int column = 0; column < columns; ++column)
    for (const auto& [fate, begin] : all[column])
      for (int row = begin; row < rows; ++row)
        grid.cells[static_cast<std::size_t>(row) * columns + column] = fate;
  return grid;
}

}  // namespace hair
