// STAFF ONLY. P2: hidden cases of how tightly lambda is solved for, and of what is reported about that.
#include <algorithm>
#include <cmath>
#include <utility>

#include "grader/exercise/P2/answers.h"
#include "grader/exercise/P2/cases.h"
#include "grader/suite/linear_system.h"

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

// A straight chain, pulled along at its tip: the tension falls evenly to 0 at its other end. The right-hand side is 0 but for the
// last rod, a product with the matrix carries it one rod further, and so ConjGrad needs as many steps as there are rods, less one:
// here more than 100.
void expect_steps_for_all_rods(Trial& trial) {
  ConstrainedSystem pulled = at_rest(random_chain(trial.random, 160));
  pulled.name = "straight chain, pulled at its tip";
  const int rods = static_cast<int>(pulled.constraints.rods.size());
  pulled.particles.mass.setConstant(trial.random.uniform(0.5, 2));
  pulled.f.setZero();
  pulled.f[3 * rods] = trial.random.uniform(1, 10);
  for (int i = 0; i <= rods; ++i) pulled.state.x.segment<3>(3 * i) = Eigen::Vector3d(i, 0, 0);
  pulled = held(pulled);
  const Solved solved = solve(trial, pulled);
  expect_solved(trial, pulled, solved.lambda, 1e-10);
  trial.expect(solved.steps >= rods - 1, "the number of steps that is reported is not ConjGrad's",
               std::to_string(solved.steps) + " for " + std::to_string(rods) + " rods in a row");
}

// Of the solve before.
void expect_limit(Trial& trial, const ConstrainedSystem& system) {
  if (trial.provided_solves().size() != 1) return;
  const int most = trial.provided_solves()[0].most, limit = std::max(100, 20 * system.rows());
  const bool default_is_the_same = limit == std::max(100, 2 * system.rows());
  trial.expect(most == limit || (most == 0 && default_is_the_same),
               "ConjGrad gets other iterations than the header says",
               std::to_string(most) + " instead of " + std::to_string(limit));
}

}  // namespace

void tolerance_and_report(Trial& trial) {
  Random& random = trial.random;
  // Forces of 1e30 N tell a residual from its square, which for small ones is lost in rounding.
  for (const auto& [n, scale] : {std::pair{2, 1.0}, {3, 1.0}, {10, 1.0}, {30, 1.0}, {10, 1e30}, {220, 1.0}}) {
    ConstrainedSystem system = at_rest(held(random_chain(random, n)));
    system.f *= scale;
    const Solved solved = solve(trial, system);
    expect_limit(trial, system);
    const double rounding = system.residual_rounding(solved.lambda);
    expect_solved(trial, system, solved.lambda, 1e-10);
    trial.expect_at_most(std::abs(solved.residual - true_residual(system, solved.lambda)), rounding,
                         "the error of the residual that is reported");
    // Rounding moves the end of ill-conditioned systems by some steps.
    const int expected = reference_steps(system);
    trial.expect(solved.steps >= expected * 2 / 3 - 2 && solved.steps <= expected * 3 / 2 + 2,
                 "the number of steps that is reported is not ConjGrad's, or many more than it needs",
                 std::to_string(solved.steps) + ", of " + std::to_string(expected));
  }
  expect_steps_for_all_rods(trial);
  ConstrainedSystem none = random_chain(random, 3);
  none.name = "no constraints";
  none.constraints = {};
  const Solved nothing = solve(trial, none);
  trial.expect(nothing.steps == 0 && nothing.residual == 0, "no constraints take steps, or leave a residual");

  // Two lengths for one rod: it ends, and does not claim a solution. The difference of the two rows'
  // right-hand sides over sqrt(2), here 50 and more, is in the way of any. The matrix is singular: rounding
  // may send lambda so far along its kernel that the residual is lost in the products' rounding, and then a
  // right ConjGrad may take it for 0.
  ConstrainedSystem both = at_rest(held(random_chain(random, 3)));
  both.name = "two lengths";
  both.constraints.rods.push_back(both.constraints.rods[0]);
  both.constraints.rods.back().length += 1;
  both.constraints.stiffness = 100;
  const VectorXd rhs = both.right_hand_side();
  const double least = std::abs(rhs[0] - rhs[2]) / std::sqrt(2.0);
  const Solved claimed = solve(trial, both);
  const double rounding = both.residual_rounding(claimed.lambda);
  trial.expect(!(claimed.residual < 0.99 * least - rounding),
               "constraints that contradict each other are reported as solved",
               std::to_string(claimed.residual) + ", rounding " + std::to_string(rounding));
}

}  // namespace grader::p2
