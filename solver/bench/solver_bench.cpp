// The reference's ConjGrad against Eigen's, and products that know their matrix against those with a table of
// it.
//
// A round times both solvers and a triad over as much memory, one right after the other, so that what else
// the machine does meets all three. `ratio` is the median of the rounds' ratios; times and rates are those of
// the fastest round.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "solver/bench/operators.h"
#include "solver/normal_equations.h"
#include "solver/study/eigen_conj_grad.h"
#include "solver/timing.h"

namespace solver_bench {
namespace {

using Vector = std::vector<double>;

// Vectors that a sweep reads or writes, each counted once a sweep, summed over an iteration's sweeps.
//   ConjGrad  Ad 2, d'Ad 2, r and r'r 3, x and d 5
//   Eigen     Ad 2, d'Ad 2, x 3, r 3, r'r 1, z = r 2, r'z 2, d 3
constexpr double kPasses = 12, kEigenPasses = 18;
constexpr double kTolerance = 1e-10;
constexpr int kMostSteps = 500;

Vector scattered(int n) {
  Vector values(n);
  unsigned state = 1;
  for (double& value : values) value = static_cast<int>(state = 1664525 * state + 1013904223) * 0x1p-31;
  return values;
}

template <class Work>
double seconds(Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void compare(benchmark::State& state, implicitMatrix& A, int n) {
  Vector b = scattered(n), x(n), product(n);
  double squared = 0;
  for (double v : b) squared += v * v;
  const double epsilon = kTolerance * kTolerance * squared;
  const int triad_length =
      n * 4 / 3 + 1;  // ConjGrad's sweeps go over x, r, d and Ad: three vectors of that many bytes
  Vector a(triad_length), c(triad_length, 1.0), e(triad_length, 2.0);
  const int repeats = 1 + 200'000 / n;  // what is timed takes a tenth of a millisecond at least

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

// "Why implicitMatrix?": one product with the strand's matrix, by its formula and by the table of its
// entries.
void product_by_formula(benchmark::State& state) {
  const int n = static_cast<int>(state.range(0));
  StrandOperator A(n / 3, 1e4);
  Vector x = scattered(n), b(n);
  for (auto _ : state) {
    A.matVecMult(x.data(), b.data());
    benchmark::DoNotOptimize(b.data());
  }
}
BENCHMARK(product_by_formula)->Arg(90)->Arg(900)->Arg(3000);

void product_by_table(benchmark::State& state) {
  const int n = static_cast<int>(state.range(0));
  StrandOperator A(n / 3, 1e4);
  Vector table(static_cast<std::size_t>(n) * n), unit(n, 0.0);
  for (int i = 0; i < n; ++i) {  // A is symmetric: its columns are its rows
    unit[i] = 1;
    A.matVecMult(unit.data(), &table[static_cast<std::size_t>(i) * n]);
    unit[i] = 0;
  }
  auto dense = dense_matrix(n, n, table.data());
  Vector x = scattered(n), b(n);
  for (auto _ : state) {
    dense->matVecMult(x.data(), b.data());
    benchmark::DoNotOptimize(b.data());
  }
}
BENCHMARK(product_by_table)->Arg(90)->Arg(900)->Arg(3000);

}  // namespace
}  // namespace solver_bench
