// STAFF ONLY.
#include "grader/suite/P2/answers.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "grader/wire/constraints_message.h"
#include "grader/wire/particles_message.h"
#include "grader/wire/strand_message.h"
#include "solver/symmetric_eigen.h"

namespace grader::p2 {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MessageReader ask(Trial& trial, int function, const ConstrainedSystem& system,
                  std::initializer_list<VectorXd> vectors, bool changes = false) {
  trial.describe(system.name + ", " + std::to_string(system.constraints.rods.size()) + " rods and " +
                 std::to_string(system.constraints.wires.size()) + " wires");
  MessageWriter request;
  request.put(function);
  put(request, system.constraints);
  put(request, system.particles);
  put(request, system.state.x);
  put(request, system.state.v);
  for (const VectorXd& vector : vectors) put(request, vector);
  if (function == kMatrix) request.put(changes);
  return trial.ask(request,
                   [](int, const auto&, auto&) -> bool { throw MalformedMessage("no operator is served"); });
}

}  // namespace

VectorXd answer(Trial& trial, int function, const ConstrainedSystem& system,
                std::initializer_list<VectorXd> vectors, Eigen::Index size) {
  MessageReader reply = ask(trial, function, system, vectors);
  const VectorXd result = get_vector(reply, size);
  reply.expect_end();
  return result;
}

VectorXd product(Trial& trial, const ConstrainedSystem& system, const VectorXd& multiplier, double junk,
                 bool changes) {
  MessageReader reply =
      ask(trial, kMatrix, system, {multiplier, VectorXd::Constant(system.rows(), junk)}, changes);
  const VectorXd first = get_vector(reply, system.rows());
  trial.expect(get_vector(reply, system.rows()) == multiplier, "the matrix's product changes its input");
  trial.expect(get_vector(reply, system.rows()) == first || !first.allFinite(),
               "the matrix gives another product the second time");
  reply.expect_end();
  return first;
}

Solved solve(Trial& trial, const ConstrainedSystem& system) {
  MessageReader reply = ask(trial, kSolve, system, {system.f, VectorXd::Constant(system.rows(), 1e3)});
  Solved solved;
  solved.steps = reply.get<int>();
  solved.residual = reply.get<double>();
  solved.lambda = get_vector(reply, system.rows());
  reply.expect_end();
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
