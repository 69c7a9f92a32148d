// STAFF ONLY. Asks a student's functions of P2 and compares the answers.
#include "reference/P2/answers.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "grader/judge/cases/case_asker.h"
#include "reference/P2/calls.h"

namespace grader::p2 {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd values(Trial& trial, const ConstrainedSystem& system, double junk) {
  trial.describe(system.name);
  return answer_of<Calls, particles::constraint_values>(trial, system.constraints, system.state.x,
                                                        VectorXd::Constant(system.rows(), junk));
}

VectorXd rates(Trial& trial, const ConstrainedSystem& system, double junk) {
  trial.describe(system.name);
  return answer_of<Calls, particles::constraint_rates>(
      trial, system.constraints, system.state.x, system.state.v, VectorXd::Constant(system.rows(), junk));
}

VectorXd with_forces(Trial& trial, const ConstrainedSystem& system, const VectorXd& lambda,
                     const VectorXd& f) {
  trial.describe(system.name);
  return answer_of<Calls, particles::add_constraint_forces>(trial, system.constraints, system.state.x, lambda,
                                                            f);
}

VectorXd product(Trial& trial, const ConstrainedSystem& system, const VectorXd& multiplier, double junk,
                 bool changes) {
  trial.describe(system.name);
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

Solved solve(Trial& trial, const ConstrainedSystem& system, double before) {
  trial.describe(system.name);
  const auto [report, lambda] = answer_of<Calls, particles::solve_constraints>(
      trial, system.constraints, system.particles, system.state, system.f,
      VectorXd::Constant(system.rows(), before));
  return {report.steps, report.residual, lambda};
}

namespace {

// An answer that is less than a thousandth of the right size proves nothing if it agrees.
constexpr double kSomething = 1e-3;

// The student's J v, for any v.
VectorXd own_rates(Trial& trial, ConstrainedSystem system, const VectorXd& v) {
  system.state.v = v;
  return rates(trial, system, 0);
}

struct Own {
  double residual, right_hand_side;  // norms
};
Own own_residual(Trial& trial, const ConstrainedSystem& system, const VectorXd& lambda) {
  // One question a statement: a sum may ask in any order.
  VectorXd rhs = -system.curvature() - system.constraints.stiffness * values(trial, system, 0);
  rhs -= own_rates(trial, system, system.inverse_masses().cwiseProduct(system.f));
  rhs -= system.constraints.damping * rates(trial, system, 0);
  const VectorXd product = p2::product(trial, system, lambda, 0);
  const bool something = product.norm() >= kSomething * system.right_hand_side().norm();
  return {something ? (rhs - product).norm() : std::numeric_limits<double>::infinity(), rhs.norm()};
}

}  // namespace

void expect_matrix(Trial& trial, const ConstrainedSystem& system) {
  for (double junk : {0.0, kNaN}) {
    const VectorXd multiplier = random_vector(trial.random, system.rows());
    const VectorXd found = product(trial, system, multiplier, junk), expected = system.matrix() * multiplier;
    const double bound = 2 * (16 + system.rows()) * kUnit * system.matrix_size() * multiplier.norm();
    double error = (found - expected).norm();
    if (!(error <= bound) && found.norm() >= kSomething * expected.norm()) {
      const VectorXd force = with_forces(trial, system, multiplier, VectorXd::Zero(3 * system.n()));
      error = (found - own_rates(trial, system, system.inverse_masses().cwiseProduct(force))).norm();
    }
    trial.expect_at_most(error, bound, "the error of a product with J W J'",
                         {found, expected, 1, multiplier});
  }
}

void expect_residual(Trial& trial, const ConstrainedSystem& system, const VectorXd& lambda, Bound bound,
                     const std::string& what, const std::function<double(double)>& error) {
  const VectorXd right = system.right_hand_side(), product = system.matrix() * lambda;
  double found = error((right - product).norm());
  if (!(found <= bound.most())) {
    const Own own = own_residual(trial, system, lambda);
    found = error(own.residual);
    bound.promised *= own.right_hand_side / right.norm();  // the header's promise is relative to it
  }
  trial.expect_at_most(found, bound, what, {product, right, 1});
}

void expect_solved(Trial& trial, const ConstrainedSystem& system, const VectorXd& lambda, double tolerance) {
  expect_residual(trial, system, lambda,
                  {tolerance * system.right_hand_side().norm(), system.residual_rounding(lambda)},
                  "what is left of the constraints' acceleration");
}

void expect_same_lambda(Trial& trial, const VectorXd& a, const VectorXd& b, const std::string& what) {
  trial.expect(b.norm() > 0, "lambda is 0 where there is something to hold");
  trial.expect_close({a, b, 1}, kTolerance * b.norm(), what);
}

}  // namespace grader::p2
