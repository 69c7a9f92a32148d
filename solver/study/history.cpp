#include "solver/study/history.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace solver::study {

namespace {

constexpr double kLessAndLess = 1.2;  // ratio of two consecutive numbers of iterations
constexpr int kPatience = 6;          // so many of these without progress
constexpr double kDone = 1e-6;        // a larger error is a plateau, and no end

Progress after(const ConjGradFunction& solve, const System& system, int iterations, double first_error) {
  CountingMatrix A(*system.matrix);
  Vector x(system.solution.size()), b = system.right_side;
  int steps = iterations;
  const double returned = solve(system.n(), &A, x.data(), b.data(), 0, &steps);
  Progress progress;
  progress.asked = iterations;
  progress.iterations = steps;
  progress.products = A.count();
  progress.error = energy_norm(*system.matrix, difference(x, system.solution)) / first_error;
  const double squared_b = squared_norm(system.right_side);
  progress.squared_residual =
      squared_norm(difference(system.right_side, product(*system.matrix, x))) / squared_b;
  progress.claimed = returned / squared_b;
  return progress;
}

}  // namespace

History history_of(const ConjGradFunction& solve, const std::string& name, const System& system, int most,
                   const Watch& watch) {
  History history = {system.name, name, system.n(), system.condition(), {}};
  const double first_error = energy_norm(*system.matrix, difference(system.right_side, system.solution));
  double best = std::numeric_limits<double>::infinity();
  int without_progress = 0;
  for (int m = 1; m <= most; m = std::max(m + 1, static_cast<int>(m * kLessAndLess))) {
    watch.look();
    Progress progress = after(solve, system, m, first_error);
    if (progress.iterations < m && !history.progress.empty() &&
        progress.iterations <= history.progress.back().iterations)
      break;  // the run before also ended by itself
    history.progress.push_back(progress);
    if (!std::isfinite(progress.error)) break;
    without_progress = progress.error < 0.9 * best ? 0 : without_progress + 1;
    best = std::min(best, progress.error);
    if (best < kDone && without_progress >= kPatience) break;
  }
  return history;
}

void time_in_turn(const System& system, const std::vector<TimedHistory>& histories,
                  std::vector<TimedCall> calls, const Timing& timing, const Watch& watch) {
  Vector x(system.solution.size()), b = system.right_side;
  for (const TimedHistory& one : histories)
    for (Progress& progress : one.history->progress)
      calls.push_back({[&, solve = one.solve, most = progress.asked] {
                         watch.look();
                         int steps = most;
                         (*solve)(system.n(), system.matrix.get(), x.data(), b.data(), 0, &steps);
                       },
                       &progress.seconds});
  std::vector<std::function<void()>> all;
  for (const TimedCall& one : calls) all.push_back(one.call);
  const std::vector<double> seconds = median_seconds(timing, all);
  for (std::size_t i = 0; i < calls.size(); ++i) *calls[i].seconds = seconds[i];
}

double error_bound(double condition, int iterations) {
  const double root = std::sqrt(condition);
  return 2 * std::pow((root - 1) / (root + 1), iterations);
}

}  // namespace solver::study
