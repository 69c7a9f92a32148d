// Compares ConjGrad and the normal equations with other methods; the results are plain data. See
// solver/README.md for the conclusions.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "solver/not_implemented.h"
#include "solver/study/history.h"
#include "solver/study/normal_digits.h"

namespace solver::study {

// The studied functions: the course's own or a student's.
struct Functions {
  ConjGradFunction conj_grad;
  NormalEquationsFunction normal_equations;  // may be empty
};

struct Settings {
  bool quick = false;
};

// A direct method: it takes no iterations.
struct DirectSolve {
  std::string system, solver;
  double error = 0;             // as Progress::error
  double squared_residual = 0;  // likewise
  double factor_seconds = 0, solve_seconds = 0;
};

// Iterations until ||b - Ax|| <= 1e-8 ||b||; for the normal equations, until ||A'(b - Ax)|| <= 1e-8 ||A'b||.
// None if it took more than most_iterations, or if its claim is false (see iterations_needed).
struct IterationsNeeded {
  double condition = 1;
  std::optional<int> conj_grad, eigen, clustered, normal_equations;
  double bound = 1;  // needed_at_most
};
inline constexpr double kNeededTolerance = 1e-8;
inline constexpr int kUnknowns = 200, kNeededClusters = 5;

// sqrt(c)/2 log(2 sqrt(c) / 1e-8): an upper bound without rounding, because error_bound gives ||r_m|| <= 2
// sqrt(c) ((sqrt(c) - 1) / (sqrt(c) + 1))^m ||r_0||, where ||r_0|| <= ||b|| (see kLargestEigenvalue).
double needed_at_most(double condition);

// The number of iterations, at most `most`, that a solver reports to reach that tolerance. None if it did not
// reach it: the study computes the residual from x, with an allowance for rounding. Also none if it took more
// than twice the products that this many iterations need, because then it did not count them. (For the normal
// equations: products with A.)
std::optional<int> iterations_needed(const ConjGradFunction& solve, const System& system, int most);
std::optional<int> normal_iterations_needed(const NormalEquationsFunction& solve, const System& system,
                                            int most);

// The measurements on one system, timed in turn.
struct Compared {
  History conj_grad, eigen;
  std::optional<DirectSolve> direct;  // if the matrix is banded

  std::vector<const History*> histories() const { return {&conj_grad, &eigen}; }
};

struct SolverStudy {
  bool quick = false;
  int most_iterations = 0;           // the limit for every solver
  std::vector<Compared> conditions;  // spread spectra of growing condition number
  std::vector<Compared> strands;     // a strand, for several time steps
  std::vector<IterationsNeeded> needed;
  std::vector<DigitsLost> digits;             // empty without normal equations
  std::optional<NotImplemented> not_written;  // the normal equations, if they are a stub
  double cpu_seconds = 0;
};

// Empty if `interrupted`. Throws NotImplemented if ConjGrad is a stub. Calls `say` before each part, with its
// name.
std::optional<SolverStudy> study_solvers(const Functions& functions, const Settings& settings,
                                         const std::atomic<bool>& interrupted,
                                         const std::function<void(const std::string&)>& say);

}  // namespace solver::study
