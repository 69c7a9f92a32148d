// STAFF ONLY. P2: hidden cases of the tolerance of solves for lambda, and of their report.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "grader/judge/cases/linear_system.h"
#include "reference/P2/answers.h"

namespace grader::p2 {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// ConjGrad's steps on the same system, whose matrix is a table.
int reference_steps(const ConstrainedSystem& system) {
  struct Table : implicitMatrix {
    void matVecMult(double x[], double b[]) override {
      Eigen::Map<VectorXd>(b, A.rows()) = A * Eigen::Map<const VectorXd>(x, A.rows());
    }
    MatrixXd A;
  } table;
  table.A = system.matrix();
  VectorXd rhs = system.right_hand_side(), lambda(rhs.size());
  int steps = std::max(100, 20 * system.rows());
  ConjGrad(system.rows(), &table, lambda.data(), rhs.data(), std::pow(1e-10 * rhs.norm(), 2), &steps);
  return steps;
}

// Checks the limit of the solve before. Fewer than five rows take too few steps for that.
void expect_limit(Trial& trial, const ConstrainedSystem& system) {
  if (trial.provided_solves().size() != 1 || system.rows() < 5) return;
  const int most = trial.provided_solves()[0].most, limit = std::max(100, 20 * system.rows());
  const bool default_is_the_same = limit == std::max(100, 2 * system.rows());
  trial.expect(most == limit || (most == 0 && default_is_the_same),
               "ConjGrad gets other iterations than the header says",
               std::to_string(most) + " instead of " + std::to_string(limit));
}

}  // namespace

// Everything is at rest, and only the stiffness of the feedback pulls, at rods that share no particle and
// have lengths from 1 to `longest`. Their squares are the matrix's eigenvalues, so the number of steps grows
// with `longest`: rods of one length take a step or two.
void report(Trial& trial) {
  Random& random = trial.random;
  // Forces of 1e30 N tell a residual from its square; with small forces rounding hides the difference.
  for (const auto& [rods, longest, scale] : {std::tuple{1, 1.0, 1.0},
                                             {3, 2.0, 1.0},
                                             {10, 5.0, 1.0},
                                             {30, 10.0, 1.0},
                                             {30, 1.0, 1.0},
                                             {10, 5.0, 1e30},
                                             {160, 30.0, 1.0}}) {
    ConstrainedSystem system = at_rest(separate_rods(random, rods));
    system.name = "rods of different lengths";
    system.f.setZero();
    system.constraints.stiffness = scale * random.uniform(10, 100);
    for (int i = 0; i < rods; ++i) {
      const double length = std::pow(longest, rods == 1 ? 0.0 : double(i) / (rods - 1));
      system.state.x.segment<3>(6 * i + 3) *= length;
      system.state.x.segment<3>(6 * i) *= length;
      system.constraints.rods[i].length *= length;
    }
    const Solved solved = solve(trial, system);
    expect_limit(trial, system);
    expect_solved(trial, system, solved.lambda, 1e-10);
    expect_residual(trial, system, solved.lambda, system.residual_rounding(solved.lambda),
                    "the error of the residual that is reported",
                    [&](double residual) { return std::abs(solved.residual - residual); });
    // Rounding moves the end of ill-conditioned systems by some steps.
    const int expected = reference_steps(system);
    trial.expect(solved.steps >= expected * 2 / 3 - 2 && solved.steps <= expected * 3 / 2 + 2,
                 "the number of steps that is reported is not ConjGrad's, or many more than it needs",
                 std::to_string(solved.steps) + ", of " + std::to_string(expected));
  }

  // Two particles are in one place, and the rod between them should be longer: J = 0, so there is no
  // solution. The call must end, and not claim one.
  ConstrainedSystem apart = at_rest(separate_rods(random, 1));
  apart.name = "a rod whose ends are in one place";
  apart.state.x.tail<3>() = apart.state.x.head<3>();
  apart.f.setZero();
  apart.constraints.stiffness = 100;
  trial.expect(!(solve(trial, apart).residual < 0.99 * apart.right_hand_side().norm()),
               "constraints that nothing can hold are reported as solved");
}

}  // namespace grader::p2
