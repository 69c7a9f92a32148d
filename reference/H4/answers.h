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

}  // namespace grader::h4
