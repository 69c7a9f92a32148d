// What ConjGrad and the normal equations do, measured beside other ways, as plain data: see solver/README.md
// for what is learned from it.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "solver/not_implemented.h"
#include "solver/study/history.h"
#include "solver/study/normal_digits.h"
#include "solver/study/product_cost.h"

namespace solver::study {

// What is studied: anybody's.
struct Functions {
  ConjGradFunction conj_grad;
  NormalEquationsFunction normal_equations;  // may be empty
};

struct Settings {
  bool quick = false;
};

// A way that takes no iterations.
struct DirectSolve {
  std::string system, solver;
  double error = 0;             // as Progress'
  double squared_residual = 0;  // likewise
  double factor_seconds = 0, solve_seconds = 0;
};

// Iterations until ||b - Ax|| <= 1e-8 ||b||; of the normal equations until ||A'(b - Ax)|| <= 1e-8 ||A'b||.
// None: not within most_iterations, or not true (see iterations_needed).
struct IterationsNeeded {
  double condition = 1;
  std::optional<int> conj_grad, eigen, clustered, normal_equations;
  double bound = 1;  // needed_at_most
};
inline constexpr double kNeededTolerance = 1e-8;
inline constexpr int kUnknowns = 200, kNeededClusters = 5;

// sqrt(c)/2 log(2 sqrt(c) / 1e-8): more are not needed without rounding, as error_bound gives ||r_m|| <= 2
// sqrt(c) ((sqrt(c) - 1) / (sqrt(c) + 1))^m ||r_0||, where ||r_0|| <= ||b|| (see kLargestEigenvalue).
double needed_at_most(double condition);

// How many iterations a solver says that it took to get there, within `most`. None if it did not: the residual
// is computed from x, and allowed what rounding may do to it. None, too, if it took more than twice as many
// products as that many iterations do, so that it did not count. (Of the normal equations: products with A.)
std::optional<int> iterations_needed(const ConjGradFunction& solve, const System& system, int most);
std::optional<int> normal_iterations_needed(const NormalEquationsFunction& solve, const System& system,
                                            int most);

// What was done on one system, timed in turn.
struct Compared {
  History conj_grad, eigen;
  std::optional<DirectSolve> direct;  // where the matrix has a band
};

struct SolverStudy {
  bool quick = false;
  int most_iterations = 0;           // that any solver is given
  std::vector<Compared> conditions;  // spread spectra of growing condition number
  std::vector<Compared> clusters;    // one condition number, fewer and more different eigenvalues
  std::vector<Compared> strands;     // a strand, for several steps of time
  std::vector<IterationsNeeded> needed;
  std::vector<DigitsLost> digits;  // empty without normal equations
  std::vector<ProductCost> products;
  std::optional<NotImplemented> not_written;  // the normal equations, if they are a stub
  double cpu_seconds = 0;
};

// Empty if `interrupted`. Throws NotImplemented if ConjGrad is a stub. `say` hears what comes next.
std::optional<SolverStudy> study_solvers(const Functions& functions, const Settings& settings,
                                         const std::atomic<bool>& interrupted,
                                         const std::function<void(const std::string&)>& say);

}  // namespace solver::study
