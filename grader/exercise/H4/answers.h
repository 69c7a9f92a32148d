// STAFF ONLY. A student's answers about an implicit step, requested through the pipe while the suite serves
// the force; and their comparison with the table of implicit_system.h.
#pragma once

#include "grader/suite/implicit_system.h"
#include "grader/suite/rounding.h"
#include "grader/suite/trial.h"

namespace grader::h4 {

inline constexpr double kTolerance = particles::kSolveTolerance;

struct Solution {
  Eigen::VectorXd dv;
  Eigen::VectorXd x, v;  // after a step of implicit_euler
  particles::SolveReport report;
  int forces, dfdx, dfdv, bands;  // the suite's own counts
};

// Call the student's solve_implicit and implicit_euler.
Solution solve(Trial& trial, const Cloud& cloud, double a, double b, double tolerance = kTolerance);
Solution step(Trial& trial, const Cloud& cloud, double h, double tolerance = kTolerance);

// Compares the matrix' product, computed twice, with the table's.
void expect_matrix(Trial& trial, const Cloud& cloud, double a, double b);

// Checks with the suite's own table that dv solves the system. One category tests the tolerance; for the
// others an error of a hundredth is enough.
void expect_solves(Trial& trial, const ImplicitSystem& system, const Eigen::VectorXd& dv,
                   double tolerance = 1e-2);

}  // namespace grader::h4
