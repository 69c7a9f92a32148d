// STAFF ONLY. A student's answers about rods and wires, requested through the pipe, and their comparison with
// the tables of system.h.
#pragma once

#include <functional>
#include <limits>
#include <string>

#include "grader/judge/cases/random.h"
#include "grader/judge/cases/trial.h"
#include "reference/P2/system.h"

namespace grader::p2 {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// The residual that categories with solves allow, relative to the right-hand side. It is coarse, so that only
// the tolerance's own category tests the tolerance.
inline constexpr double kTolerance = 1e-3;

// C and J v, in buffers that hold `junk` before; and f + J^T lambda.
Eigen::VectorXd values(Trial& trial, const ConstrainedSystem& system, double junk);
Eigen::VectorXd rates(Trial& trial, const ConstrainedSystem& system, double junk);
Eigen::VectorXd with_forces(Trial& trial, const ConstrainedSystem& system, const Eigen::VectorXd& lambda,
                            const Eigen::VectorXd& f);

// A product with the matrix, computed twice into buffers with junk. With `changes`, the matrix was made when
// rods, masses and positions had other values.
Eigen::VectorXd product(Trial& trial, const ConstrainedSystem& system, const Eigen::VectorXd& multiplier,
                        double junk, bool changes = false);

struct Solved {
  int steps;
  double residual;  // the student's reported value
  Eigen::VectorXd lambda;
};

// `before` is what lambda holds on entry.
Solved solve(Trial& trial, const ConstrainedSystem& system, double before = 0);

// The student's parts are compared with the tables of system.h, each in its own category. An answer that is
// made of them is right, too, if it agrees with the student's own parts and these do something. So a mistake
// in one of them is not counted again.
void expect_matrix(Trial& trial, const ConstrainedSystem& system);

// The error of ||right-hand side - J W J' lambda|| is at most the bound.
void expect_residual(Trial& trial, const ConstrainedSystem& system, const Eigen::VectorXd& lambda,
                     Bound bound, const std::string& what,
                     const std::function<double(double)>& error = std::identity());
void expect_solved(Trial& trial, const ConstrainedSystem& system, const Eigen::VectorXd& lambda,
                   double tolerance = kTolerance);

// Two of the student's answers agree within kTolerance of their size, which is not 0.
void expect_same_lambda(Trial& trial, const Eigen::VectorXd& a, const Eigen::VectorXd& b,
                        const std::string& what);

}  // namespace grader::p2
