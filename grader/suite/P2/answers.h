// STAFF ONLY. A student's answers about rods and wires, asked across the pipe, beside p2_system.h's tables.
#pragma once

#include <initializer_list>
#include <limits>

#include "grader/suite/P2/system.h"
#include "grader/suite/random_vector.h"
#include "grader/suite/rounding.h"
#include "grader/suite/trial.h"

namespace grader::p2 {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// The residual that the categories which solve allow, of the right-hand side: coarse, so that the tolerance is
// looked at in its own category alone.
inline constexpr double kTolerance = 1e-3;

inline constexpr int kValues = 0, kRates = 1, kForces = 2, kMatrix = 3, kSolve = 4;  // as in serve_P2.cpp

// A function's vector of `size` entries, for the vectors that it takes.
Eigen::VectorXd answer(Trial& trial, int function, const ConstrainedSystem& system,
                       std::initializer_list<Eigen::VectorXd> vectors, Eigen::Index size);

// A product with the matrix, twice into buffers that hold junk.
Eigen::VectorXd product(Trial& trial, const ConstrainedSystem& system, const Eigen::VectorXd& multiplier,
                        double junk);

struct Solved {
  int steps;
  double residual;  // as the student reports it
  Eigen::VectorXd lambda;
};

Solved solve(Trial& trial, const ConstrainedSystem& system);
double true_residual(const ConstrainedSystem& system, const Eigen::VectorXd& lambda);

void expect_matrix(Trial& trial, const ConstrainedSystem& system);
void expect_solved(Trial& trial, const ConstrainedSystem& system, const Eigen::VectorXd& lambda,
                   double tolerance = kTolerance);

// Where lambda is not the only solution: it accelerates the particles as any does.
void expect_same_accelerations(Trial& trial, const ConstrainedSystem& system);

}  // namespace grader::p2
