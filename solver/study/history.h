// How a method of conjugate gradients gets on, from iteration to iteration.
//
// ConjGrad tells nothing on its way, and any may be asked: so it is called anew for 1, 2, 3, ... iterations,
// and for fewer and fewer numbers of them further on; what it returns each time is compared with the solution
// that is known.
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

// Of a study that runs. `interrupted` may be null.
struct Watch {
  const std::atomic<bool>* interrupted = nullptr;

  // Throws Interrupted.
  void look() const {
    if (interrupted && *interrupted) throw Interrupted();
  }
};

struct Progress {
  int asked = 0;  // how many iterations it might take
  int iterations = 0;
  long products = 0;            // with A, counted
  double error = 0;             // ||x - x*||_A / ||b - x*||_A: 1 at the first guess
  double squared_residual = 0;  // ||b - Ax||^2 / ||b||^2, computed from x
  double claimed = 0;           // the same as the solver returned it
  double seconds = 0;           // of CPU time that so many iterations take
};

struct History {
  std::string system, solver;
  int n = 0;
  double condition = 1;
  std::vector<Progress> progress;
};

// Until the solver gets no better, ends by itself, or has taken `most` iterations. Values that are not finite
// are kept as they are, and end it.
History history_of(const ConjGradFunction& solve, const std::string& name, const System& system, int most,
                   const Watch& watch);

// Sets the seconds of histories of one system, each by the solver beside it, and those of other calls: all in
// turn, so that they can be compared.
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

// What the error can be at most after so many iterations, without rounding: 2 ((sqrt(c) - 1) / (sqrt(c) +
// 1))^m for the condition number c (Golub and Van Loan, "Matrix Computations", 4th edition, theorem 11.3.3).
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
