// Measures how the error of a conjugate gradient method shrinks from iteration to iteration.
//
// ConjGrad reports nothing while it runs. So the study calls it anew for 1, 2, 3, ... iterations, with
// growing gaps further on, and compares each result with the known solution. This works for any
// implementation.
#pragma once

#include <algorithm>
#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "solver/linearSolver.h"
#include "solver/study/systems.h"
#include "solver/timing.h"

namespace solver::study {

// As ConjGrad: (n, A, x, b, epsilon, steps), the squared residual.
using ConjGradFunction = std::function<double(int, implicitMatrix*, double[], double[], double, int*)>;

struct Interrupted {};

// Lets a running study be interrupted. `interrupted` may be null.
struct Watch {
  const std::atomic<bool>* interrupted = nullptr;

  // Throws Interrupted.
  void look() const {
    if (interrupted && *interrupted) throw Interrupted();
  }
};

// The duration of calls: CPU time of this thread, medians of repeats.
struct Timing {
  double least_seconds = 1e-4;  // per repeat; a repeat makes several calls if they are shorter
  int repeats = 5;              // a third of them if a call takes 10 least_seconds or more

  int repeats_of(double call_seconds) const {
    return call_seconds < 10 * least_seconds ? repeats : (repeats + 2) / 3;
  }
};

// The seconds that each of the calls takes. The calls are repeated in turn, so that a temporary slowdown of
// the machine affects all of them. The first calls warm up and determine how many calls make a repeat.
inline std::vector<double> median_seconds(const Timing& how,
                                          const std::vector<std::function<void()>>& calls) {
  const auto seconds = [&](std::size_t call, long times) {
    const double start = timing::cpu_seconds();
    for (long i = 0; i < times; ++i) calls[call]();
    return timing::cpu_seconds() - start;
  };
  std::vector<long> times(calls.size(), 1);
  std::vector<int> repeats;
  for (std::size_t call = 0; call < calls.size(); ++call) {
    double taken = seconds(call, 1);
    while (taken < how.least_seconds && times[call] < (1L << 30)) {
      const double needed = taken > 0 ? static_cast<double>(times[call]) * how.least_seconds / taken : 0;
      times[call] = std::max(2 * times[call], static_cast<long>(needed));
      taken = seconds(call, times[call]);
    }
    repeats.push_back(how.repeats_of(taken / static_cast<double>(times[call])));
  }
  std::vector<std::vector<double>> all(calls.size());
  for (int repeat = 0; repeat < how.repeats; ++repeat)
    for (std::size_t call = 0; call < calls.size(); ++call)
      if (repeat < repeats[call])
        all[call].push_back(seconds(call, times[call]) / static_cast<double>(times[call]));
  std::vector<double> medians;
  for (const std::vector<double>& one : all) medians.push_back(timing::median(one));
  return medians;
}

inline double median_seconds(const Timing& how, const std::function<void()>& call) {
  return median_seconds(how, std::vector{call})[0];
}

struct Progress {
  int asked = 0;  // the number of iterations that it was allowed
  int iterations = 0;
  long products = 0;            // with A, counted
  double error = 0;             // ||x - x*||_A / ||b - x*||_A: 1 at the first guess
  double squared_residual = 0;  // ||b - Ax||^2 / ||b||^2, computed from x
  double claimed = 0;           // the same, as the solver returned it
  double seconds = 0;           // CPU time of these iterations
};

struct History {
  std::string system, solver;
  int n = 0;
  double condition = 1;
  std::vector<Progress> progress;
};

// Runs until the solver gets no better, ends by itself, or has taken `most` iterations. Values that are not
// finite are kept as they are and end the history.
History history_of(const ConjGradFunction& solve, const std::string& name, const System& system, int most,
                   const Watch& watch);

// Measures the seconds of several histories of one system, each with its solver, and of other calls. All are
// repeated in turn, so that their times can be compared.
struct TimedHistory {
  const ConjGradFunction* solve;
  History* history;
};
struct TimedCall {
  std::function<void()> call;
  double* seconds;
};
void time_in_turn(const System& system, const std::vector<TimedHistory>& histories,
                  std::vector<TimedCall> calls, const Timing& timing, const Watch& watch);

// The bound of the error after this many iterations, without rounding: 2 ((sqrt(c) - 1) / (sqrt(c) + 1))^m
// for the condition number c (Golub and Van Loan, "Matrix Computations", 4th edition, theorem 11.3.3).
double error_bound(double condition, int iterations);

// Counts the products with a matrix.
class CountingMatrix : public implicitMatrix {
 public:
  explicit CountingMatrix(implicitMatrix& A) : A_(A) {}
  void matVecMult(double x[], double b[]) override {
    ++count_;
    A_.matVecMult(x, b);
  }
  long count() const { return count_; }

 private:
  implicitMatrix& A_;
  long count_ = 0;
};

// Eigen's conjugate gradients behind ConjGrad's interface: no preconditioner, the same operator, first guess
// and stopping rule. As ConjGrad, but ends when ||b - Ax|| < tolerance ||b||.
void eigen_conj_grad(int n, implicitMatrix* A, double x[], double b[], double tolerance, int* steps);

}  // namespace solver::study
