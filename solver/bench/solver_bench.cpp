// Compares the reference's ConjGrad with Eigen's.
//
// A round times both solvers and a triad over as much memory, one right after the other, so that other load
// on the machine affects all three. `ratio` is the median of the rounds' ratios; times and rates are those of
// the fastest round.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "solver/bench/operators.h"
#include "solver/study/eigen_conj_grad.h"
#include "solver/study/systems.h"
#include "solver/timing.h"

namespace solver_bench {
namespace {

using solver::study::Vector;

// Vectors that a sweep reads or writes, each counted once a sweep, summed over an iteration's sweeps.
//   ConjGrad  Ad 2, d'Ad 2, r and r'r 3, x and d 5
//   Eigen     Ad 2, d'Ad 2, x 3, r 3, r'r 1, z = r 2, r'z 2, d 3
constexpr double kPasses = 12, kEigenPasses = 18;
constexpr double kTolerance = 1e-10;
constexpr int kMostSteps = 500;

template <class Work>
double seconds(Work work) {
  const timing::Stopwatch watch;
  work();
  return watch.seconds();
}

void compare(benchmark::State& state, implicitMatrix& A, int n) {
  Vector b = solver::study::scattered(n, 1), x(n), product(n);
  double squared = 0;
  for (double v : b) squared += v * v;
  const double epsilon = kTolerance * kTolerance * squared;
  const int triad_length =
      n * 4 / 3 + 1;  // ConjGrad's sweeps go over x, r, d and Ad: three vectors of that many bytes
  Vector a(triad_length), c(triad_length, 1.0), e(triad_length, 2.0);
  const int repeats = 1 + 200'000 / n;  // a measurement takes at least a tenth of a millisecond

  Vector ratios, ours, eigens, operators, triads;
  int steps = 0, eigen_steps = 0;
  for (auto _ : state) {
    const double our_time = seconds([&] {
      for (int k = 0; k < repeats; ++k) ConjGrad(n, &A, x.data(), b.data(), epsilon, &(steps = kMostSteps));
    });
    const double eigen_time = seconds([&] {
      for (int k = 0; k < repeats; ++k)
        solver::study::eigen_conj_grad(n, &A, x.data(), b.data(), kTolerance, &(eigen_steps = kMostSteps));
    });
    const double operator_time = seconds([&] {
      for (int k = 0; k < 20 * repeats; ++k) A.matVecMult(b.data(), product.data());
    });
    const double triad_time = seconds([&] {
      for (int k = 0; k < 20 * repeats; ++k) triad(triad_length, a.data(), c.data(), 3, e.data());
    });
    ours.push_back(our_time / repeats / steps);
    eigens.push_back(eigen_time / repeats / eigen_steps);
    operators.push_back(operator_time / repeats / 20);
    triads.push_back(triad_time / repeats / 20);
    ratios.push_back(ours.back() / eigens.back());
    state.SetIterationTime(our_time);
  }
  const double nano = 1e9, vector_gigabytes = 8e-9 * n;
  state.counters["ratio"] = timing::median(ratios);
  state.counters["steps"] = steps;
  state.counters["eigen_steps"] = eigen_steps;
  auto fastest = [](const Vector& times) { return *std::min_element(times.begin(), times.end()); };
  state.counters["ns_per_step"] = fastest(ours) * nano;
  state.counters["eigen_ns"] = fastest(eigens) * nano;
  state.counters["product_ns"] = fastest(operators) * nano;
  state.counters["GBps"] = kPasses * vector_gigabytes / fastest(ours);
  state.counters["eigen_GBps"] = kEigenPasses * vector_gigabytes / fastest(eigens);
  state.counters["triad_GBps"] = 3 * 8e-9 * triad_length / fastest(triads);
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
