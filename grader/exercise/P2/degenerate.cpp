// STAFF ONLY. P2: hidden cases of pinned particles and of constraints that say the same twice, or nothing.
#include <cmath>

#include "grader/exercise/P2/answers.h"
#include "grader/exercise/P2/cases.h"

namespace grader::p2 {

using Eigen::Vector3d;
using Eigen::VectorXd;

// Pinned particles have no inverse mass, whatever their mass, and move with the velocity that they have.
void pinned_particles(Trial& trial) {
  Random& random = trial.random;
  for (int n : {2, 3, 8}) {
    ConstrainedSystem system = at_rest(held(random_chain(random, n)));
    system.name = "pinned, " + system.name;
    system.particles.pinned[random.integer(0, 1) == 0 ? 0 : n - 1] = 1;
    expect_matrix(trial, system);
    expect_solved(trial, system, solve(trial, system).lambda);
  }
  // The pull in a pendulum's rod, m g cos(angle), whatever pulls at its pivot.
  const double length = random.uniform(0.5, 2), angle = random.uniform(0.3, 1.2),
               mass = random.uniform(0.5, 4);
  ConstrainedSystem pendulum;
  pendulum.name = "pendulum";
  pendulum.particles = {Eigen::Vector2d(random.uniform(0.5, 4), mass), {1, 0}};
  pendulum.state = {VectorXd::Zero(6), VectorXd::Zero(6)};
  pendulum.state.x.tail<3>() = length * Vector3d(std::sin(angle), 0, -std::cos(angle));
  pendulum.f = 30 * random_vector(random, 6);
  pendulum.f.tail<3>() = Vector3d(0, 0, -9.81 * mass);
  pendulum.constraints.rods = {{1, 0, length}};
  const double expected = mass * 9.81 * std::cos(angle) / length;
  trial.expect_at_most(std::abs(solve(trial, pendulum).lambda[0] + expected), kTolerance * expected,
                       "the error of a pendulum's lambda");

  // A rod between pinned particles holds nothing.
  ConstrainedSystem nothing = at_rest(held(random_chain(random, 5)));
  nothing.name = "rod between pinned particles";
  nothing.particles.pinned[0] = nothing.particles.pinned[1] = 1;
  expect_same_accelerations(trial, nothing);
}

namespace {

// A braced rectangle with sides of 3 and 4, diagonals of 5, and masses, all times powers of 2, that moves and falls as one. Each
// term of the right-hand side is 0 exactly.
ConstrainedSystem falling_as_one(Random& random) {
  const auto power = [&] { return std::ldexp(1.0, random.integer(-4, 2)); };
  ConstrainedSystem system;
  system.name = "braced rectangle that falls as one";
  const double unit = power();
  system.particles = {VectorXd(4), {0, 0, 0, 0}};
  system.state = {VectorXd::Zero(12), Vector3d(power(), -power(), power()).replicate(4, 1)};
  system.f = VectorXd::Zero(12);
  const Vector3d acceleration(power(), power(), -power());
  const Vector3d corners[] = {{0, 0, 0}, {0, 3, 0}, {0, 3, 4}, {0, 0, 4}};
  for (int i = 0; i < 4; ++i) {
    system.particles.mass[i] = power();
    system.state.x.segment<3>(3 * i) = unit * corners[i];
    system.f.segment<3>(3 * i) = system.particles.mass[i] * acceleration;
  }
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < i; ++j)
      system.constraints.rods.push_back({i, j, unit * (corners[i] - corners[j]).norm()});
  system.constraints.stiffness = 400;
  system.constraints.damping = 40;
  return system;
}

}  // namespace

void redundant(Trial& trial) {
  Random& random = trial.random;
  // Rods twice and three times, either end first.
  ConstrainedSystem twice = at_rest(held(random_chain(random, 5)));
  twice.name = "rods twice";
  for (int k = 0; k < 4; ++k) {
    const particles::Rod rod = twice.constraints.rods[k];
    twice.constraints.rods.push_back({rod.j, rod.i, rod.length});
  }
  twice.constraints.rods.push_back(twice.constraints.rods[0]);
  expect_same_accelerations(trial, twice);

  // Six particles, all fifteen distances: three more than a rigid body needs.
  expect_same_accelerations(trial, at_rest(rigid_body(random, 6)));

  // A rod of length 0 holds nothing.
  ConstrainedSystem nothing = at_rest(random_chain(random, 5));
  nothing.name = "rod of length 0";
  nothing.state.x.segment<3>(9) = nothing.state.x.segment<3>(6);
  expect_same_accelerations(trial, held(nothing));

  const Solved falling = solve(trial, falling_as_one(random));
  trial.expect_at_most(falling.lambda.norm(), 0, "lambda where nothing is to be done");
}

}  // namespace grader::p2
