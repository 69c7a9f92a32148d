#include "hair/lab/solver/solver_series.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hair/io/plot/page.h"

namespace hair::solver_lab {

namespace {

using namespace solver::study;

constexpr double kZero = 1e-34;  // stands for an exact zero on a logarithmic axis

std::string note_of(const Progress& progress) {
  return std::to_string(progress.iterations) + " iterations, " + std::to_string(progress.products) +
         " products";
}

}  // namespace

Point point(double x, double y, std::string note) {
  Point p = {x, y, std::move(note)};
  if (!std::isfinite(y)) {
    p.failed = true;
    p.note += (p.note.empty() ? "" : ", ") + std::string("no solution");
  } else if (y < kZero) {
    p.y = kZero;
    p.note += (p.note.empty() ? "" : ", ") + std::string("as good as zero");
  }
  return p;
}

Series series_of(const History& history, const std::string& name, Against against, Measure measure) {
  Series series = {name, {}};
  for (const Progress& progress : history.progress) {
    const double x = against == Against::iterations ? std::max(1, progress.iterations)
                     : against == Against::products ? static_cast<double>(std::max(1L, progress.products))
                                                    : progress.seconds;
    series.points.push_back(
        point(x, measure == Measure::error ? progress.error : progress.squared_residual, note_of(progress)));
  }
  return series;
}

Series bound_of(const History& history, const std::string& name, int look) {
  Series series = {name, {}, true, false, true, look};
  for (const Progress& progress : history.progress) {
    const int iterations = std::max(1, progress.iterations);
    const double bound = error_bound(history.condition, iterations);
    if (bound < 1e-16) break;
    series.points.push_back({static_cast<double>(iterations), bound});
  }
  return series;
}

std::string condition_name(const History& history) {
  return "condition " + to_text(history.condition);
}

}  // namespace hair::solver_lab
