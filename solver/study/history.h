// Measures how the error of a conjugate gradient method shrinks from iteration to iteration.
//
// ConjGrad reports nothing while it runs. So the study calls it anew for 1, 2, 3, ... iterations, with
// growing gaps further on, and compares each result with the known solution. This works for any
// implementation.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "solver/study/cpu_time.h"
#include "solver/study/systems.h"

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

}  // namespace solver::study
