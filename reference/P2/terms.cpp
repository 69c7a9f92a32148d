// STAFF ONLY. P2: hidden cases of the solve's parts: C, J v, J^T lambda, J W J^T.
#include <cmath>

#include "reference/P2/answers.h"

namespace grader::p2 {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

void expect_values_and_rates(Trial& trial, const std::vector<ConstrainedSystem>& systems) {
  for (const ConstrainedSystem& system : systems)
    for (double junk : {0.0, kNaN}) {
      trial.expect_close({values(trial, system, junk), system.values(), 1}, 32 * kUnit * system.value_size(),
                         "the error of C");
      const MatrixXd J = system.jacobian();
      trial.expect_close({rates(trial, system, junk), J * system.state.v, 1},
                         32 * kUnit * (J.cwiseAbs() * system.state.v.cwiseAbs()).norm(), "the error of J v");
    }
}

void expect_forces(Trial& trial, const std::vector<ConstrainedSystem>& systems) {
  for (const ConstrainedSystem& system : systems) {
    const VectorXd lambda = random_vector(trial.random, system.rows());
    const VectorXd there = 10 * random_vector(trial.random, 3 * system.n());
    const MatrixXd Jt = system.jacobian().transpose();
    const VectorXd f = with_forces(trial, system, lambda, there);
    trial.expect_close(
        {f - there, Jt * lambda},
        (16 + system.rows()) * kUnit * ((Jt.cwiseAbs() * lambda.cwiseAbs()).norm() + 2 * there.norm()),
        "the error of the constraint forces");
  }
}

}  // namespace

void rod_values(Trial& trial) {
  expect_values_and_rates(trial, chains(trial.random));
}

void wire_values(Trial& trial) {
  expect_values_and_rates(trial, beads(trial.random));
}

void rod_forces(Trial& trial) {
  expect_forces(trial, chains(trial.random));
}

void wire_forces(Trial& trial) {
  expect_forces(trial, beads(trial.random));
}

void matrix(Trial& trial) {
  for (const std::vector<ConstrainedSystem>& systems : {chains(trial.random), beads(trial.random)})
    for (const ConstrainedSystem& system : systems) expect_matrix(trial, system);

  // A matrix that was made when rods, masses and positions had other values, and one that is made now.
  const ConstrainedSystem system = random_chain(trial.random, 5);
  const VectorXd multiplier = random_vector(trial.random, system.rows());
  const VectorXd now = product(trial, system, multiplier, 0),
                 later = product(trial, system, multiplier, 0, true);
  trial.expect_close({later, now, 1},
                     2 * (16 + system.rows()) * kUnit * system.matrix_size() * multiplier.norm(),
                     "the error of a product with J W J', made before rods, masses and positions changed");
}

}  // namespace grader::p2
