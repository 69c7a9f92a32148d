// STAFF ONLY. P2: hidden cases of the solve's parts, C, J v, J^T lambda and J W J^T; of pinned particles, and
// of constraints that hold nothing.
#include <cmath>

#include "reference/P2/answers.h"

namespace grader::p2 {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
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

// Rods share no particle below, and masses are equal, so that other categories' mistakes don't show there.

// Pinned particles have an inverse mass of 0, with any mass and any force on them, and keep their velocity.
void pinned(Trial& trial) {
  Random& random = trial.random;
  for (int rods : {1, 2, 4}) {
    ConstrainedSystem system = at_rest(held(separate_rods(random, rods)));
    system.name = "pinned ends";
    system.particles.mass.setOnes();  // a mistake in 1 / m is another category's
    for (const particles::Rod& rod : system.constraints.rods) system.particles.pinned[rod.j] = 1;
    const VectorXd lambda = solve(trial, system).lambda;
    ConstrainedSystem pulled = system;
    pulled.name = "pinned ends of other masses, pulled";
    for (int i = 0; i < system.n(); ++i)
      if (system.particles.is_pinned(i)) {
        pulled.particles.mass[i] = random.uniform(2, 9);
        pulled.f.segment<3>(3 * i) *= -30;
      }
    for (const ConstrainedSystem* one : {&system, &pulled}) expect_matrix(trial, *one);
    expect_same_lambda(trial, solve(trial, pulled).lambda, lambda,
                       "the change of lambda where pinned particles have another mass and force");
  }
  // The pinned ends move.
  ConstrainedSystem moving = held(separate_rods(random, 3));
  moving.name = "pinned ends that move";
  for (int k : {0, 2}) moving.particles.pinned[moving.constraints.rods[k].j] = 1;
  moving.f.setZero();
  expect_solved(trial, moving, solve(trial, moving).lambda);
}

// A rod of length 0, and one between pinned particles, hold nothing: the others' lambda is the same without
// them.
void nothing(Trial& trial) {
  Random& random = trial.random;
  const ConstrainedSystem held_rods = at_rest(held(separate_rods(random, 3)));
  ConstrainedSystem without = held_rods, zero = held_rods, pinned = held_rods;
  without.constraints.rods.erase(without.constraints.rods.begin() + 1);
  zero.name = "rod of length 0";
  zero.state.x.segment<3>(9) = zero.state.x.segment<3>(6);
  zero.constraints.rods[1].length = 0;
  pinned.name = "rod between pinned particles";
  pinned.particles.pinned[2] = pinned.particles.pinned[3] = 1;
  const VectorXd expected = solve(trial, without).lambda;
  for (const ConstrainedSystem* system : {&zero, &pinned}) {
    const VectorXd lambda = solve(trial, *system).lambda;
    expect_same_lambda(trial, Eigen::Vector2d(lambda[0], lambda[2]), expected,
                       "the change of lambda for a rod that holds nothing");
  }

  // A braced rectangle with sides of 3 and 4 and diagonals of 5 that rests. Each term of the right-hand side
  // is 0 exactly.
  ConstrainedSystem rectangle = separate_rods(random, 2);
  rectangle.name = "braced rectangle at rest";
  const Vector3d corners[] = {{0, 0, 0}, {0, 3, 0}, {0, 3, 4}, {0, 0, 4}};
  for (int i = 0; i < 4; ++i) rectangle.state.x.segment<3>(3 * i) = corners[i];
  rectangle.state.v.setZero();
  rectangle.f.setZero();
  rectangle.constraints = {{}, {}, 400, 40};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < i; ++j)
      rectangle.constraints.rods.push_back({i, j, (corners[i] - corners[j]).norm()});
  trial.expect_at_most(solve(trial, rectangle).lambda.norm(), 0, "lambda where nothing is to be done");

  ConstrainedSystem none = random_chain(random, 3);
  none.name = "no constraints";
  none.constraints = {};
  const Solved nothing = solve(trial, none);
  trial.expect(nothing.steps == 0 && nothing.residual == 0, "no constraints take steps, or leave a residual");
}

}  // namespace grader::p2
