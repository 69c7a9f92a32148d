// STAFF ONLY. A student's answers about an implicit step, requested through the pipe while the suite serves
// the force or the matrix.
#pragma once

#include "grader/judge/cases/implicit_system.h"
#include "grader/judge/cases/trial.h"

namespace grader::h4 {

// More than any program needs for an answer: counts have a category of their own.
inline constexpr int kMostQuestions = 100'000;

// Counts of the force's evaluations and products.
struct Asked {
  int forces, dfdx, dfdv;
};

// The product of implicit_matrix with x, made twice. Its output holds `junk` before.
struct Product {
  Eigen::VectorXd product, again, x;
  Asked asked;
};
Product multiply(Trial& trial, const Cloud& cloud, double a, double b, const Eigen::VectorXd& x,
                 double junk = 0);

struct RightSide {
  Eigen::VectorXd rhs;
  Asked asked;
};
RightSide right_side(Trial& trial, const Cloud& cloud, double a, double b, double junk = 0);

struct Step {
  Eigen::VectorXd x, v;
  particles::SolveReport report;
  Asked asked;
};
Step step(Trial& trial, const Cloud& cloud, double h, double tolerance = particles::kSolveTolerance);

// The part of the cases in other units that is about solve_plain.
void expect_same_solve_in_other_units(Trial& trial);

// Particles under forces whose parts can be left out one by one, and soft hair.

// The derivatives that a force has. Even with none it still has a force.
enum class Parts { none, dfdx, dfdv, all };

// n particles of 0.4 to 3 kg whose df/dx and df/dv depend on places and velocities.
Cloud mixed_cloud(Random& random, int n, Parts parts);
Cloud with(Cloud cloud, Parts parts);

// n free particles of about 1 kg in a chain of springs with h^2 k/m = 0.1. With `banded` the force knows its
// band.
Cloud soft_hair(Random& random, int n, double h, bool banded);

}  // namespace grader::h4
