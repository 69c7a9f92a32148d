// STAFF ONLY.
#include "grader/exercise/P2/answers.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "grader/exercise/P2/calls.h"
#include "grader/suite/case_asker.h"
#include "solver/symmetric_eigen.h"

namespace grader::p2 {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

void describe(Trial& trial, const ConstrainedSystem& system) {
  trial.describe(system.name + ", " + std::to_string(system.constraints.rods.size()) + " rods and " +
                 std::to_string(system.constraints.wires.size()) + " wires");
}

}  // namespace

VectorXd values(Trial& trial, const ConstrainedSystem& system, double junk) {
  describe(trial, system);
  VectorXd C = VectorXd::Constant(system.rows(), junk);
  ask_student_for<Calls, particles::constraint_values>(trial, system.constraints, system.state.x, C);
  return C;
}

VectorXd rates(Trial& trial, const ConstrainedSystem& system, double junk) {
  describe(trial, system);
  VectorXd rates = VectorXd::Constant(system.rows(), junk);
  ask_student_for<Calls, particles::constraint_rates>(trial, system.constraints, system.state.x,
                                                      system.state.v, rates);
  return rates;
}

VectorXd with_forces(Trial& trial, const ConstrainedSystem& system, const VectorXd& lambda, VectorXd f) {
  describe(trial, system);
  ask_student_for<Calls, particles::add_constraint_forces>(trial, system.constraints, system.state.x, lambda,
                                                           f);
  return f;
}

VectorXd product(Trial& trial, const ConstrainedSystem& system, const VectorXd& multiplier, double junk,
                 bool changes) {
  describe(trial, system);
  ConstrainedSystem before = system;
  std::reverse(before.constraints.rods.begin(), before.constraints.rods.end());
  before.particles.mass *= 2;
  before.state.x *= 1.5;
  using Matrix = Client<Calls, particles::constraint_matrix>;
  CaseAsker asker(trial);
  const VectorXd there = VectorXd::Constant(system.rows(), junk);
  const auto made = std::tie(before.constraints, before.particles, before.state);
  const auto now = std::tie(system.constraints, system.particles, system.state);
  const auto answer = changes ? Matrix::multiply(asker, 2, multiplier, there, made, now)
                              : Matrix::multiply(asker, 2, multiplier, there, now);
  const VectorXd& first = answer.products[0];
  trial.expect(answer.x == multiplier, "the matrix's product changes its input");
  trial.expect(answer.products[1] == first || !first.allFinite(),
               "the matrix gives another product the second time");
  return first;
}

Solved solve(Trial& trial, const ConstrainedSystem& system) {
  describe(trial, system);
  Solved solved;
  solved.lambda = VectorXd::Constant(system.rows(), 1e3);
  const particles::ConstraintReport report = ask_student_for<Calls, particles::solve_constraints>(
      trial, system.constraints, system.particles, system.state, system.f, solved.lambda);
  solved.steps = report.steps;
  solved.residual = report.residual;
  return solved;
}

double true_residual(const ConstrainedSystem& system, const VectorXd& lambda) {
  return (system.right_hand_side() - system.matrix() * lambda).norm();
}

void expect_matrix(Trial& trial, const ConstrainedSystem& system) {
  for (double junk : {0.0, kNaN}) {
    const VectorXd multiplier = random_vector(trial.random, system.rows());
    trial.expect_at_most((product(trial, system, multiplier, junk) - system.matrix() * multiplier).norm(),
                         2 * (16 + system.rows()) * kUnit * system.matrix_size() * multiplier.norm(),
                         "the error of a product with J W J'");
  }
}

void expect_solved(Trial& trial, const ConstrainedSystem& system, const VectorXd& lambda, double tolerance) {
  trial.expect_at_most(true_residual(system, lambda),
                       tolerance * system.right_hand_side().norm() + system.residual_rounding(lambda),
                       "what is left of the constraints' acceleration");
}

// Accelerations of the particles: with A = J W J' and any solution s, the difference of accelerations in the
// norm of the masses is that of lambda in the norm of A, at most residual / sqrt(A's smallest eigenvalue that
// is not 0).
void expect_same_accelerations(Trial& trial, const ConstrainedSystem& system) {
  const VectorXd lambda = solve(trial, system).lambda;
  const MatrixXd A = system.matrix();
  const solver::SymmetricEigen eigen = solver::symmetric_eigen(A);
  const double zero = 1e-10 * eigen.values.maxCoeff();
  const VectorXd rhs = system.right_hand_side();
  VectorXd solution = VectorXd::Zero(system.rows());
  double smallest = eigen.values.maxCoeff();
  for (int i = 0; i < system.rows(); ++i) {
    const double eigenvalue = eigen.values[i];
    if (eigenvalue < zero) continue;
    smallest = std::min(smallest, eigenvalue);
    solution += eigen.vectors.col(i) * (eigen.vectors.col(i).dot(rhs) / eigenvalue);
  }
  const VectorXd root = system.inverse_masses().cwiseSqrt();
  const VectorXd difference = root.cwiseProduct(system.jacobian().transpose() * (lambda - solution));
  trial.expect_at_most(difference.norm(),
                       (kTolerance * rhs.norm() + system.residual_rounding(lambda)) / std::sqrt(smallest),
                       "the error of the accelerations");
}

}  // namespace grader::p2
