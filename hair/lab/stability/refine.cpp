#include "hair/lab/stability/refine.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "particles/require.h"

namespace hair {

namespace {

struct Interrupted {};

// A stretch of a column: its class, and its first row. Stretches go from the lowest row up.
struct Stretch {
  int fate, begin;
};
using Column = std::vector<Stretch>;

bool same_classes(const Column& a, const Column& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Stretch& s, const Stretch& t) { return s.fate == t.fate; });
}

class Refiner {
 public:
  Refiner(int columns, int rows, const std::function<int(int, int)>& classify,
          const std::atomic<bool>& interrupted)
      : rows_(rows),
        classify_(classify),
        interrupted_(interrupted),
        known_(static_cast<std::size_t>(columns) * rows, -1),
        columns_(columns) {}

  // Fills columns until it ends; throws Interrupted.
  void run() {
    const int last = static_cast<int>(columns_.size()) - 1;
    std::vector<int> coarse;
    for (int column = 0; column < last; column += kCoarse) coarse.push_back(column);
    coarse.push_back(last);
    for (const int column : coarse) columns_[column] = search(column);
    for (std::size_t i = 1; i < coarse.size(); ++i) between(coarse[i - 1], coarse[i]);
  }

  RefinedGrid grid() const {
    const int width = static_cast<int>(columns_.size());
    RefinedGrid grid{std::vector<int>(known_.size(), -1), asked_, true};
    for (int column = 0; column < width; ++column) {
      const Column& stretches = columns_[column];
      if (stretches.empty()) grid.complete = false;
      for (std::size_t k = 0; k < stretches.size(); ++k)
        for (int row = stretches[k].begin, end = k + 1 < stretches.size() ? stretches[k + 1].begin : rows_;
             row < end; ++row)
          grid.cells[static_cast<std::size_t>(row) * width + column] = stretches[k].fate;
    }
    return grid;
  }

 private:
  int ask(int column, int row) {
    int& known = known_[static_cast<std::size_t>(row) * columns_.size() + column];
    if (known < 0) {
      if (interrupted_) throw Interrupted();
      known = classify_(column, row);
      ++asked_;
    }
    return known;
  }

  // The first row after `low` whose class differs from low's; high is such a row.
  int boundary(int column, int low, int high) {
    const int below = ask(column, low);
    while (high - low > 1) {
      const int middle = (low + high) / 2;
      (ask(column, middle) == below ? low : high) = middle;
    }
    return high;
  }

  // Adds the column's stretches above the last of `result`.
  Column search(int column, Column result) {
    for (int low = result.back().begin; low < rows_ - 1;) {
      const int high = std::min(low + kCoarse, rows_ - 1);
      // There may be more than two classes from low to high.
      while (ask(column, high) != result.back().fate) {
        const int row = boundary(column, std::max(low, result.back().begin), high);
        result.push_back({ask(column, row), row});
      }
      low = high;
    }
    return result;
  }
  Column search(int column) { return search(column, {{ask(column, 0), 0}}); }

  // The row where the class `above` follows `below`, searched from `row` on, at `least` or higher. Returns
  // nothing if a cell at the expected place has another class.
  std::optional<int> boundary_near(int column, int row, int below, int above, int least) {
    // Low has the class below, high the one above; each step doubles.
    std::optional<int> low, high;
    for (int stride = 1; !low || !high; stride *= 2) {
      const int asked = !low && !high ? row : low ? *low + stride / 2 : *high - stride / 2;
      if (asked < least || asked >= rows_) return {};
      const int fate = ask(column, asked);
      if (fate != below && fate != above) return {};
      (fate == below ? low : high) = asked;
    }
    while (*high - *low > 1) {
      const int middle = (*low + *high) / 2, fate = ask(column, middle);
      if (fate != below && fate != above) return {};
      (fate == below ? *low : *high) = middle;
    }
    return high;
  }

  // Boundaries of both neighbours are searched at their mean; from the first boundary that only one neighbour
  // has, or that is not found, the whole rest of the column is searched.
  Column follow(int column, const Column& left, const Column& right) {
    if (left[0].fate != right[0].fate) return search(column);
    Column result = {{left[0].fate, 0}};
    for (std::size_t k = 1; k < std::max(left.size(), right.size()); ++k) {
      if (k >= left.size() || k >= right.size() || left[k].fate != right[k].fate)
        return search(column, std::move(result));
      const std::optional<int> row = boundary_near(column, (left[k].begin + right[k].begin) / 2,
                                                   left[k - 1].fate, left[k].fate, result.back().begin);
      if (!row) return search(column, std::move(result));
      result.push_back({left[k].fate, *row});
    }
    return result;
  }

  // True if each stretch has its class at its begin, in its middle and at its end.
  bool holds(int column, const Column& stretches) {
    for (std::size_t k = 0; k < stretches.size(); ++k) {
      const auto [fate, begin] = stretches[k];
      const int last = (k + 1 < stretches.size() ? stretches[k + 1].begin : rows_) - 1;
      for (const int row : {begin, (begin + last) / 2, last})
        if (ask(column, row) != fate) return false;
    }
    return true;
  }

  void between(int left, int right) {
    if (right - left < 2) return;
    const int middle = (left + right) / 2;
    const Column &a = columns_[left], &b = columns_[right];
    bool near = right - left == 2 && same_classes(a, b);
    for (std::size_t k = 0; near && k < a.size(); ++k) near = std::abs(a[k].begin - b[k].begin) <= 2;
    if (near) {
      Column& mean = columns_[middle] = a;
      for (std::size_t k = 0; k < a.size(); ++k) mean[k].begin = (a[k].begin + b[k].begin) / 2;
    } else {
      columns_[middle] = follow(middle, a, b);
      const bool halfway = right - left > kCoarse / 2;
      if (halfway && !holds(middle, columns_[middle])) columns_[middle] = search(middle);
    }
    between(left, middle);
    between(middle, right);
  }

  int rows_;
  const std::function<int(int, int)>& classify_;
  const std::atomic<bool>& interrupted_;
  std::vector<int> known_;  // -1: not evaluated yet
  std::vector<Column> columns_;
  long asked_ = 0;
};

}  // namespace

RefinedGrid refine(int columns, int rows, const std::function<int(int column, int row)>& classify,
                   const std::atomic<bool>& interrupted) {
  particles::require_at_least("the columns of a grid", columns, 2);
  particles::require_at_least("the rows of a grid", rows, 2);
  Refiner refiner(columns, rows, classify, interrupted);
  try {
    refiner.run();
  } catch (const Interrupted&) {
    // Cells that are not known yet stay so.
  }
  return refiner.grid();
}

}  // namespace hair
