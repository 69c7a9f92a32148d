// STAFF ONLY. Systems Ax = b with their known properties, and calls of a student's ConjGrad on them.
//
// Bounds. With u = 2^-53, e the rounding error of a product divided by u, ||A|| and X = 2||x*|| + ||b||, the
// header's contract gives
//
//   drift = 65 (10 + 2e) u ||A|| X + (n + 2) u sqrt(value)
//
// between the square root of the return value and the true ||b - Ax||. 65 is one more than the header's 64,
// for the true residual computed here; n + 2 roundings are for a sum of n squares. If no solution is known,
// or A is singular, the returned x replaces x*. Then
//
//   ||x - x*|| <= (sqrt(epsilon) + drift) / lambda_min.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "grader/judge/cases/trial.h"
#include "solver/linearSolver.h"
#include "solver/matrices.h"

namespace grader::inline judge {

struct LinearSystem {
  std::string name;
  std::shared_ptr<implicitMatrix> A;
  std::vector<double> b;
  std::vector<double> solution;  // empty: unknown
  double norm = 1;               // >= ||A||
  double smallest = 0;           // a lower bound of the smallest eigenvalue; 0: unknown
  double product_error = 1;      // e

  int n() const { return static_cast<int>(b.size()); }
};

// Makes a system with this solution, up to the rounding of one product.
LinearSystem with_solution(std::string name, std::shared_ptr<implicitMatrix> A, std::vector<double> solution,
                           double norm, double smallest, double product_error);
LinearSystem sparse_system(std::string name, const solver::SparseMatrix& A, std::vector<double> solution,
                           double smallest);

// Makes a full matrix with the given spectrum, and a random solution of length about one.
LinearSystem spectral_system(std::string name, std::vector<double> spectrum, Random& random);

struct Solution {
  double value = 0;  // ConjGrad's return value
  int steps = 0;
  std::vector<double> x;
  int products = 0;  // is counted by the suite, over all calls
};

double norm(const std::vector<double>& v);
double distance(const std::vector<double>& a, const std::vector<double>& b);  // ||a - b||
// Compares bits: a NaN equals itself, 0 and -0 differ.
bool same_bits(const std::vector<double>& a, const std::vector<double>& b);
LinearSystem scaled(LinearSystem system, double factor);  // scales b and the solution
// Scales A and b so that ||b|| = ||b - Ab|| = 1. Then an absolute epsilon and one relative to either are the
// same: a mistake in epsilon shows only in the category about epsilon. For the same reason no epsilon of
// other categories that ends a solve is below 1e-6 or so, and fixed tolerances do no harm there. Where more
// digits are needed, epsilon is 0 and the step limit ends the solve.
LinearSystem even(const LinearSystem& system);
// Returns the default step limit, max(100, 2n), for cases about other properties.
int usual_limit(const LinearSystem& system);
double true_residual(const LinearSystem& system, const std::vector<double>& x);  // ||b - Ax||
double drift(const LinearSystem& system, const std::vector<double>& x, double value);

// Finds a tolerance at which CG takes a fixed number of steps for any order of summation: the geometric
// mean of the squared residuals before and after a step that changes them enough. If CG ends before
// `least_steps`, it takes the last such step.
struct Tolerance {
  double epsilon;
  int steps;
};
Tolerance tolerance_after(const LinearSystem& system, int least_steps);

// Calls the student's ConjGrad, and checks only that x is finite: each category checks its own property, so
// that one mistake does not fail all categories. `x` is the buffer's content on entry (b if it is empty, so
// that code that starts from there is right, too). Of several `calls`, which share b, it returns the last
// answer.
Solution solve(Trial& trial, const LinearSystem& system, double epsilon, int steps,
               std::vector<double> x = {}, int calls = 1);

// Returns the reference's answer to the same call.
Solution reference_solution(const LinearSystem& system, double epsilon, int steps);

// Checks that ||b - Ax||^2 of the returned x is at most epsilon, and that x is as close to the solution as
// this implies. It uses the suite's own product, not ConjGrad's return value.
void expect_solved(Trial& trial, const LinearSystem& system, const Solution& solution, double epsilon);
void expect_steps(Trial& trial, const Solution& solution, int expected);

// Checks that the return value is the squared norm of b - Ax, within the drift.
void expect_honest_value(Trial& trial, const LinearSystem& system, const Solution& solution);
// For systems on which rounding decides: the system is solved, or the step limit is reached. If the return
// value says that it is solved, it must be.
void expect_solved_or_at_limit(Trial& trial, const LinearSystem& system, const Solution& solution,
                               double epsilon, int limit);

// Makes a planned system (solver/matrices.h) whose residuals have these ratios, in a direction of no axis.
LinearSystem planned_system(std::string name, const std::vector<double>& ratios, Random& random);

// Solves one ordinary system: code that can't do this passes no category of extreme cases.
void expect_solves_ordinary_system(Trial& trial);

}  // namespace grader::judge
