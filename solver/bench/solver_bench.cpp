// Compares the reference's ConjGrad with Eigen's.
//
// A round times both solvers, one right after the other, so that other load on the machine affects both.
// `ratio` is the median of the rounds' ratios; times are those of the fastest round.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "solver/bench/operators.h"
#include "solver/study/history.h"
#include "solver/study/systems.h"
#include "solver/timing.h"

namespace solver_bench {
namespace {

using solver::study::Vector;

constexpr double kTolerance = 1e-10;
constexpr int kMostSteps = 500;

template <class Work>
double seconds(Work work) {
  const timing::Stopwatch watch;
  work();
  return watch.seconds();
}

void compare(benchmark::State& state, implicitMatrix& A, int n) {
  Vector b = solver::study::scattered(n, 1), x(n);
  double squared = 0;
  for (double v : b) squared += v * v;
  const double epsilon = kTolerance * kTolerance * squared;
  const int repeats = 1 + 200'000 / n;  // a measurement takes at least a tenth of a millisecond

  Vector ratios, ours, eigens;
  int steps = 0, eigen_steps = 0;
  for (auto _ : state) {
    const double our_time = seconds([&] {
      for (int k = 0; k < repeats; ++k) ConjGrad(n, &A, x.data(), b.data(), epsilon, &(steps = kMostSteps));
    });
    const double eigen_time = seconds([&] {
      for (int k = 0; k < repeats; ++k)
        solver::study::eigen_conj_grad(n, &A, x.data(), b.data(), kTolerance, &(eigen_steps = kMostSteps));
    });
    ours.push_back(our_time / repeats / steps);
    eigens.push_back(eigen_time / repeats / eigen_steps);
    ratios.push_back(ours.back() / eigens.back());
    state.SetIterationTime(our_time);
  }
  state.counters["ratio"] = timing::median(ratios);
  state.counters["steps"] = steps;
  state.counters["eigen_steps"] = eigen_steps;
  auto fastest = [](const Vector& times) { return *std::min_element(times.begin(), times.end()); };
  state.counters["ns_per_step"] = 1e9 * fastest(ours);
  state.counters["eigen_ns"] = 1e9 * fastest(eigens);
}

void strand(benchmark::State& state) {
  const int n = static_cast<int>(state.range(0));
  StrandOperator A(n / 3, 1e4);
  compare(state, A, n);
}
BENCHMARK(strand)->Arg(90)->Arg(900)->Arg(9000)->Arg(90000)->Iterations(25)->UseManualTime()->Unit(
    benchmark::kMillisecond);

void poisson(benchmark::State& state) {
  const int side = static_cast<int>(state.range(0));
  PoissonOperator A(side);
  compare(state, A, side * side);
}
BENCHMARK(poisson)->Arg(512)->Iterations(25)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace solver_bench
