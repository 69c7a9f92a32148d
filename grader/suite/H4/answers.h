// STAFF ONLY. A student's answers about an implicit step, asked across the pipe while the suite answers for
// the force; beside the table of implicit_system.h.
#pragma once

#include "grader/suite/implicit_system.h"
#include "grader/suite/rounding.h"
#include "grader/suite/trial.h"

namespace grader::h4 {

inline constexpr double kTolerance = particles::kSolveTolerance;

struct Report {
  int steps;
  double residual, rhs;
  bool converged;
};

struct Solution {
  Eigen::VectorXd dv;
  Eigen::VectorXd x, v;  // after a step of implicit_euler
  Report report;
  int forces, dfdx, dfdv;  // as the suite counted them
};

// solve_implicit and implicit_euler.
Solution solve(Trial& trial, const Cloud& cloud, double a, double b, double tolerance = kTolerance);
Solution step(Trial& trial, const Cloud& cloud, double h, double tolerance = kTolerance);

// The matrix' product, twice, is that of the table.
void expect_matrix(Trial& trial, const Cloud& cloud, double a, double b);

// dv solves the system, by the suite's own table. How tightly it has to is what one category is about; in the
// others a hundredth does.
void expect_solves(Trial& trial, const ImplicitSystem& system, const Eigen::VectorXd& dv,
                   double tolerance = 1e-2);

}  // namespace grader::h4
