// STAFF ONLY. Systems Ax = b with all that is known of them, and a student's ConjGrad put to work on them.
//
// Bounds. With u = 2^-53, e the rounding error of a product over u, ||A|| and X = 2||x*|| + ||b||, the
// header's contract gives
//
//   drift = 65 (10 + 2e) u ||A|| X + (n + 2) u sqrt(value)
//
// between the square root of the return value and the true ||b - Ax||: 65, one more than the header's 64, for
// the true residual that is taken here, and n + 2 roundings for a sum of n squares. Where no solution is
// known, or A is singular, the x that came back stands for x*. Then
//
//   ||x - x*|| <= (sqrt(epsilon) + drift) / lambda_min.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "grader/suite/trial.h"
#include "solver/linearSolver.h"
#include "solver/matrices.h"

namespace grader {

struct LinearSystem {
  std::string name;
  std::shared_ptr<implicitMatrix> A;
  std::vector<double> b;
  std::vector<double> solution;  // empty: none is known
  double norm = 1;               // >= ||A||
  double smallest = 0;           // the smallest eigenvalue, or less; 0: not known
  double product_error = 1;      // e
  // Condition 1e4 or more, or singular: the number of steps depends on the order of summation.
  bool ill_conditioned = false;

  int n() const { return static_cast<int>(b.size()); }
};

// A system whose solution is `solution`, up to the rounding of one product.
LinearSystem with_solution(std::string name, std::shared_ptr<implicitMatrix> A, std::vector<double> solution,
                           double norm, double smallest, double product_error);
LinearSystem sparse_system(std::string name, const solver::SparseMatrix& A, std::vector<double> solution,
                           double smallest);

// Full, with the spectrum given and a random solution of length about one.
LinearSystem spectral_system(std::string name, std::vector<double> spectrum, Random& random);

struct Solution {
  double value = 0;  // what ConjGrad returned
  int steps = 0;
  std::vector<double> x;
  int products = 0;        // as the suite counted them
  bool b_changed = false;  // or a product's input and output overlapped
};

double norm(const std::vector<double>& v);
double distance(const std::vector<double>& a, const std::vector<double>& b);  // ||a - b||
// The same bits: a NaN equals itself, 0 and -0 differ.
bool same_bits(const std::vector<double>& a, const std::vector<double>& b);
LinearSystem scaled(LinearSystem system, double factor);                         // b and the solution
double true_residual(const LinearSystem& system, const std::vector<double>& x);  // ||b - Ax||
double drift(const LinearSystem& system, const std::vector<double>& x, double value);

// A tolerance at which CG takes a certain number of steps, whatever the order of summation: the geometric
// mean of the squared residuals before and after that step, where they differ enough. If CG is done before
// `least_steps`, the last step that is clear.
struct Tolerance {
  double epsilon;
  int steps;
};
Tolerance tolerance_after(const LinearSystem& system, int least_steps);

// Calls the student's ConjGrad, and checks no more than that x is finite: each category looks at what it is
// about, so that one mistake does not fail them all. `x` is what the buffer holds on entry (junk if it is
// empty).
Solution solve(Trial& trial, const LinearSystem& system, double epsilon, int steps,
               std::vector<double> x = {});

// The reference's answer to the same.
Solution reference_solution(const LinearSystem& system, double epsilon, int steps);

// ||b - Ax||^2 of the x that came back is at most epsilon, and x as close to the solution as that says; by
// the suite's own product, whatever ConjGrad returned.
void expect_solved(Trial& trial, const LinearSystem& system, const Solution& solution, double epsilon);
void expect_steps(Trial& trial, const Solution& solution, int expected);

// The return value is the squared norm of b - Ax, within the drift.
void expect_honest_value(Trial& trial, const LinearSystem& system, const Solution& solution);
// products = 1 + steps + floor(steps / 64), give or take two for an ill-conditioned system; b as it was.
void expect_counted_products(Trial& trial, const LinearSystem& system, const Solution& solution);
// Solved, as it must be if the return value says so; else at the step limit. For systems on which rounding
// decides.
void expect_solved_or_at_limit(Trial& trial, const LinearSystem& system, const Solution& solution,
                               double epsilon, int limit);

// Solves one ordinary system: no code passes a category of extreme cases without it.
void expect_solves_ordinary_system(Trial& trial);

}  // namespace grader
