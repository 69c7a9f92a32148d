// STAFF ONLY. P2: hidden cases of the solve, each with only those right-hand side terms that it is about.
#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "grader/exercise/P2/answers.h"
#include "grader/exercise/P2/cases.h"

namespace grader::p2 {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

// All particles turn and fly as one body does: such velocities keep all lengths.
void move_rigidly(Random& random, ConstrainedSystem& system) {
  const VectorXd motion = random_vector(random, 6);
  const Vector3d spin = motion.head<3>(), flight = motion.tail<3>();
  for (int i = 0; i < system.n(); ++i)
    system.state.v.segment<3>(3 * i) = flight + spin.cross(Vector3d(system.state.x.segment<3>(3 * i)));
}

}  // namespace

// J W f is all of the right-hand side.
void particles_at_rest(Trial& trial) {
  for (const ConstrainedSystem& system : chains(trial.random)) {
    const ConstrainedSystem resting = at_rest(held(system));
    expect_solved(trial, resting, solve(trial, resting).lambda);
  }
  // Hair: masses of 1e-8 kg and segments of a centimetre.
  ConstrainedSystem hair = at_rest(random_chain(trial.random, 8));
  hair.name = "hair";
  hair.particles.mass *= 1e-8;
  hair.f *= 1e-8;
  hair.state.x *= 0.01;
  hair = held(hair);
  expect_solved(trial, hair, solve(trial, hair).lambda);
}

void particles_that_move(Trial& trial) {
  for (const ConstrainedSystem& system : chains(trial.random)) {
    const ConstrainedSystem moving = held(system);
    expect_solved(trial, moving, solve(trial, moving).lambda);
  }
  ConstrainedSystem top = rigid_body(trial.random, 4);
  top.f.setZero();
  move_rigidly(trial.random, top);
  expect_solved(trial, top, solve(trial, top).lambda);
}

// Everything that the other categories ask of rods.
void beads_on_wires(Trial& trial) {
  Random& random = trial.random;
  for (const std::vector<ConstrainedSystem>& systems : {beads(random), hung_chains(random)})
    for (ConstrainedSystem system : systems) {
      expect_matrix(trial, system);
      system.constraints.stiffness = random.uniform(10, 100);
      system.constraints.damping = random.uniform(1, 10);
      expect_solved(trial, system, solve(trial, system).lambda);
    }

  // A bead on a wire without any force keeps its speed: the wire turns it with m v^2 / r. The matrix is
  // diag(r^2, 1) / m.
  ConstrainedSystem bead = held(beads(random)[0]);
  bead.f.setZero();
  const particles::Wire& wire = bead.constraints.wires[0];
  const Vector3d d = bead.state.x - wire.centre;
  const double speed = random.uniform(1, 3);
  bead.state.v = speed * wire.normal.cross(d).normalized();
  const VectorXd lambda = solve(trial, bead).lambda;
  const double expected = bead.particles.mass[0] * speed * speed / (wire.radius * wire.radius);
  trial.expect_at_most(std::abs(lambda[0] + expected),
                       kTolerance * expected * (1 + wire.radius * wire.radius),
                       "the error of a bead's lambda");

  // A wire, and a rod from its pinned centre.
  ConstrainedSystem both = random_chain(random, 2);
  both.name = "wire and rod";
  add_wire(random, both, 0);
  both.particles.pinned[1] = 1;
  both.state.x.tail<3>() = both.constraints.wires[0].centre;
  both.state.v.tail<3>().setZero();
  expect_same_accelerations(trial, held(both));
}

// Feedback adds -stiffness C - damping J v to the right-hand side, and so what solves that to lambda: the
// difference of two solves.
void feedback(Trial& trial) {
  Random& random = trial.random;
  for (const ConstrainedSystem& plain : chains(random))
    for (const auto& [stiffness, damping] :
         {std::pair{random.uniform(10, 1000), 0.0}, {0.0, random.uniform(1, 50)}, {100.0, 20.0}}) {
      ConstrainedSystem with = plain;
      with.constraints.stiffness = stiffness;
      with.constraints.damping = damping;
      const VectorXd lambda = solve(trial, with).lambda, without = solve(trial, plain).lambda;
      const VectorXd expected = with.right_hand_side() - plain.right_hand_side();
      trial.expect_at_most((expected - plain.matrix() * (lambda - without)).norm(),
                           kTolerance * (with.right_hand_side().norm() + plain.right_hand_side().norm()) +
                               with.residual_rounding(lambda) + plain.residual_rounding(without),
                           "the error of the feedback");
    }
}

}  // namespace grader::p2
