// STAFF ONLY. P2: hidden cases of the solve, its tolerance and its report.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "grader/judge/cases/linear_system.h"
#include "reference/P2/answers.h"

namespace grader::p2 {
namespace {

using Eigen::MatrixXd;
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

// Solves without feedback: the terms are J W f and J' v.
void solve(Trial& trial) {
  Random& random = trial.random;
  const auto solves = [&](const ConstrainedSystem& system) {
    expect_solved(trial, system, solve(trial, system, 1e3).lambda);  // lambda is overwritten
  };
  for (const std::vector<ConstrainedSystem>& systems : {chains(random), beads(random)})
    for (const ConstrainedSystem& system : systems) {
      solves(at_rest(held(system)));
      solves(held(system));
    }
  // These are at rest, since there the rows' order may be the student's own.
  for (const ConstrainedSystem& system : hung_chains(random)) solves(at_rest(held(system)));

  ConstrainedSystem top = rigid_body(random, 4);
  top.f.setZero();
  move_rigidly(random, top);
  solves(top);

  // Hair has masses of 1e-8 kg and segments of a centimetre.
  ConstrainedSystem hair = at_rest(random_chain(random, 8));
  hair.name = "hair";
  hair.particles.mass *= 1e-8;
  hair.f *= 1e-8;
  hair.state.x *= 0.01;
  solves(held(hair));

  // Redundant constraints: rods twice and three times, either end first; six particles with all fifteen
  // distances, three more than a rigid body needs; a wire, and a rod from its pinned centre.
  ConstrainedSystem twice = at_rest(held(random_chain(random, 5)));
  twice.name = "rods twice";
  for (int k = 0; k < 4; ++k) {
    const particles::Rod rod = twice.constraints.rods[k];
    twice.constraints.rods.push_back({rod.j, rod.i, rod.length});
  }
  twice.constraints.rods.push_back(twice.constraints.rods[0]);
  solves(twice);
  solves(at_rest(rigid_body(random, 6)));
  ConstrainedSystem both = random_chain(random, 2);
  both.name = "wire and rod";
  add_wire(random, both, 0);
  both.particles.pinned[1] = 1;
  both.state.x.tail<3>() = both.constraints.wires[0].centre;
  both.state.v.tail<3>().setZero();
  both.f.tail<3>().setZero();
  solves(at_rest(held(both)));
}

// Feedback adds -stiffness C - damping J v to the right-hand side. The difference of two lambdas, with and
// without feedback, solves the system for that.
void feedback(Trial& trial) {
  Random& random = trial.random;
  const ConstrainedSystem plain = separate_rods(random, 4);
  for (const auto& terms :
       {std::pair{random.uniform(10, 1000), 0.0}, {0.0, random.uniform(1, 50)}, {100.0, 20.0}}) {
    const double stiffness = terms.first, damping = terms.second;
    ConstrainedSystem with = plain;
    with.constraints.stiffness = stiffness;
    with.constraints.damping = damping;
    const VectorXd lambda = solve(trial, with).lambda, without = solve(trial, plain).lambda;
    // The terms of the feedback alone are the right-hand side of the same particles without forces and
    // curvature.
    const auto error = [&](const VectorXd& C, const VectorXd& rate) {
      const VectorXd change = product(trial, plain, lambda - without, 0);
      return (change + stiffness * C + damping * rate).norm();
    };
    const double size = (stiffness * plain.values() + damping * plain.jacobian() * plain.state.v).norm();
    trial.expect((lambda - without).norm() > 0, "feedback changes nothing");
    const VectorXd C = values(trial, plain, 0);
    trial.expect_at_most(error(C, rates(trial, plain, 0)),
                         kTolerance * (2 * size + plain.right_hand_side().norm()) +
                             with.residual_rounding(lambda) + plain.residual_rounding(without),
                         "the error of the feedback");
  }
}

// Rods and wires of different particles do not affect each other: each part of an answer equals that of its
// own constraints alone, the rods' part first.
void rows(Trial& trial) {
  Random& random = trial.random;
  ConstrainedSystem mixed = separate_rods(random, 4);
  mixed.name = "rods, and wires of other particles";
  mixed.constraints.rods.resize(2);
  for (int i : {6, 4, 7}) add_wire(random, mixed, i);
  mixed = at_rest(held(mixed));
  ConstrainedSystem rods = mixed, wires = mixed;
  rods.constraints.wires.clear();
  wires.constraints.rods.clear();
  const auto joined = [&](const auto& ask) {
    const VectorXd a = ask(trial, rods, 0), b = ask(trial, wires, 0);
    VectorXd both(a.size() + b.size());
    both << a, b;
    return both;
  };

  const VectorXd lambda = random_vector(random, mixed.rows()), zero = VectorXd::Zero(3 * mixed.n());
  VectorXd forces = with_forces(trial, rods, lambda.head(2), zero);
  forces += with_forces(trial, wires, lambda.tail(6), zero);
  trial.expect(forces.norm() > 0, "the forces are 0");
  trial.expect_close({with_forces(trial, mixed, lambda, zero), forces}, 64 * kUnit * forces.norm(),
                     "the forces of rods and wires together, and their sum,");
  for (ConstrainedSystem* system : {&mixed, &rods, &wires}) {
    for (particles::Rod& rod : system->constraints.rods) rod.length *= 2;
    for (particles::Wire& wire : system->constraints.wires) wire.radius *= 3;
    system->state.v = mixed.f;
  }
  const VectorXd C = values(trial, mixed, 0), rate = rates(trial, mixed, 0);
  trial.expect(C == joined(values) && rate == joined(rates),
               "rods and wires together have other values or rates than each alone, in this order");
}

// The same rods in a unit of length that is 2^40 times as large, so that numbers are 1e-12. Powers of two
// round nothing.
void units(Trial& trial) {
  Random& random = trial.random;
  const double unit = 0x1p-40;
  ConstrainedSystem plain = separate_rods(random, 3);
  plain.constraints.stiffness = random.uniform(10, 100);
  ConstrainedSystem small = plain;
  small.name = "a small unit of length";
  small.state.x *= unit;
  small.state.v *= unit;
  small.f *= unit;
  for (particles::Rod& rod : small.constraints.rods) rod.length *= unit;
  const VectorXd lambda = random_vector(random, plain.rows()), zero = VectorXd::Zero(3 * plain.n());
  const VectorXd C = values(trial, plain, 0), rate = rates(trial, plain, 0),
                 force = with_forces(trial, plain, lambda, zero);
  trial.expect(C.norm() > 0 && rate.norm() > 0 && force.norm() > 0, "values, rates or forces are 0");
  trial.expect(values(trial, small, 0) == unit * unit * C && rates(trial, small, 0) == unit * unit * rate &&
                   with_forces(trial, small, lambda, zero) == unit * force,
               "values, rates or forces depend on the unit of length");
  const VectorXd of_small = solve(trial, small).lambda;
  expect_same_lambda(trial, of_small, solve(trial, plain).lambda,
                     "the lambda of rods in two units of length");
}

namespace {

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
