// STAFF ONLY. A student's answers about rods and wires, requested through the pipe, and their comparison with
// the tables of system.h.
#pragma once

#include <limits>

#include "grader/exercise/P2/system.h"
#include "grader/suite/random_vector.h"
#include "grader/suite/rounding.h"
#include "grader/suite/trial.h"

namespace grader::p2 {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// The residual that categories with solves allow, relative to the right-hand side. It is coarse, so that only
// the tolerance's own category tests the tolerance.
inline constexpr double kTolerance = 1e-3;

// C and J v, in buffers that hold `junk` before; and f + J^T lambda.
Eigen::VectorXd values(Trial& trial, const ConstrainedSystem& system, double junk);
Eigen::VectorXd rates(Trial& trial, const ConstrainedSystem& system, double junk);
Eigen::VectorXd with_forces(Trial& trial, const ConstrainedSystem& system, const Eigen::VectorXd& lambda,
                            Eigen::VectorXd f);

// A product with the matrix, computed twice into buffers with junk. With `changes`, the matrix was made when rods, masses
// and positions had other values.
Eigen::VectorXd product(Trial& trial, const ConstrainedSystem& system, const Eigen::VectorXd& multiplier,
                        double junk, bool changes = false);

struct Solved {
  int steps;
  double residual;  // the student's reported value
  Eigen::VectorXd lambda;
};

Solved solve(Trial& trial, const ConstrainedSystem& system);
double true_residual(const ConstrainedSystem& system, const Eigen::VectorXd& lambda);

void expect_matrix(Trial& trial, const ConstrainedSystem& system);
void expect_solved(Trial& trial, const ConstrainedSystem& system, const Eigen::VectorXd& lambda,
                   double tolerance = kTolerance);

// For systems with several solutions lambda: each solution must give the same accelerations.
void expect_same_accelerations(Trial& trial, const ConstrainedSystem& system);

}  // namespace grader::p2
