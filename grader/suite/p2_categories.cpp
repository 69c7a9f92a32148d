// STAFF ONLY. P2: hidden cases of rods and wires.
//
// The categories that solve allow a residual of 1e-6 of the right-hand side, so that the tolerance is looked
// at in its own alone; and each has only those terms on the right-hand side that it is about.
#include "grader/suite/p2_categories.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "grader/suite/linear_system.h"
#include "grader/suite/p2_system.h"
#include "grader/wire/constraints_message.h"
#include "grader/wire/particles_message.h"
#include "grader/wire/strand_message.h"
#include "particles/explicit_integrators.h"

namespace grader::p2 {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kUnit = 0x1p-53;
constexpr double kTolerance = 1e-3;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr int kValues = 0, kRates = 1, kForces = 2, kMatrix = 3, kSolve = 4;  // as in serve_P2.cpp

VectorXd random_vector(Random& random, int n) {
  VectorXd vector(n);
  for (double& entry : vector) entry = random.normal();
  return vector;
}

MessageReader ask(Trial& trial, int function, const ConstrainedSystem& system,
                  std::initializer_list<VectorXd> vectors) {
  trial.describe(system.name + ", " + std::to_string(system.constraints.rods.size()) + " rods and " +
                 std::to_string(system.constraints.wires.size()) + " wires");
  MessageWriter request;
  request.put(function);
  put(request, system.constraints);
  put(request, system.particles);
  put(request, system.state.x);
  put(request, system.state.v);
  for (const VectorXd& vector : vectors) put(request, vector);
  return trial.ask(request,
                   [](int, const auto&, auto&) -> bool { throw MalformedMessage("no operator is served"); });
}

VectorXd answer(Trial& trial, int function, const ConstrainedSystem& system,
                std::initializer_list<VectorXd> vectors, Eigen::Index size) {
  MessageReader reply = ask(trial, function, system, vectors);
  const VectorXd result = get_vector(reply, size);
  reply.expect_end();
  return result;
}

struct Solved {
  int steps;
  double residual;  // as the student reports it
  VectorXd lambda;
};

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

void expect_solved(Trial& trial, const ConstrainedSystem& system, const VectorXd& lambda,
                   double tolerance = kTolerance) {
  trial.expect_at_most(true_residual(system, lambda),
                       tolerance * system.right_hand_side().norm() + system.residual_rounding(lambda),
                       "what is left of the constraints' acceleration");
}

// The same system where nothing moves.
ConstrainedSystem at_rest(ConstrainedSystem system) {
  system.state.v.setZero();
  return system;
}

// Chains of rods, long and short.
std::vector<ConstrainedSystem> chains(Random& random) {
  std::vector<ConstrainedSystem> systems;
  for (int n : {2, 3, random.integer(5, 8), random.integer(9, 15)})
    systems.push_back(random_chain(random, n));
  return systems;
}

// Beads that nothing else holds, the wires not in their order.
std::vector<ConstrainedSystem> beads(Random& random) {
  std::vector<ConstrainedSystem> systems;
  for (int n : {1, 2, 4}) {
    systems.push_back(random_chain(random, n));
    systems.back().name = "beads";
    systems.back().constraints.rods.clear();
    for (int i = n - 1; i >= 0; --i) add_wire(random, systems.back(), (i + 1) % n);
  }
  return systems;
}

// Chains with a bead at either end.
std::vector<ConstrainedSystem> hung_chains(Random& random) {
  std::vector<ConstrainedSystem> systems;
  for (int n : {2, 3, random.integer(5, 8)}) {
    systems.push_back(random_chain(random, n));
    systems.back().name = "hung chain";
    add_wire(random, systems.back(), n - 1);
    add_wire(random, systems.back(), 0);
  }
  return systems;
}

void expect_values_and_rates(Trial& trial, const std::vector<ConstrainedSystem>& systems) {
  for (const ConstrainedSystem& system : systems)
    for (double junk : {0.0, kNaN}) {
      const VectorXd there = VectorXd::Constant(system.rows(), junk);
      trial.expect_at_most((answer(trial, kValues, system, {there}, system.rows()) - system.values()).norm(),
                           32 * kUnit * system.value_size(), "the error of C");
      const MatrixXd J = system.jacobian();
      trial.expect_at_most(
          (answer(trial, kRates, system, {there}, system.rows()) - J * system.state.v).norm(),
          32 * kUnit * (J.cwiseAbs() * system.state.v.cwiseAbs()).norm(), "the error of J v");
    }
}

void rod_values(Trial& trial) {
  expect_values_and_rates(trial, chains(trial.random));
}

void wire_values(Trial& trial) {
  expect_values_and_rates(trial, beads(trial.random));
}

void expect_forces(Trial& trial, const std::vector<ConstrainedSystem>& systems) {
  for (const ConstrainedSystem& system : systems) {
    const VectorXd lambda = random_vector(trial.random, system.rows());
    const VectorXd there = 10 * random_vector(trial.random, 3 * system.n());
    const MatrixXd Jt = system.jacobian().transpose();
    const VectorXd f = answer(trial, kForces, system, {lambda, there}, there.size());
    trial.expect_at_most(
        (f - there - Jt * lambda).norm(),
        (16 + system.rows()) * kUnit * ((Jt.cwiseAbs() * lambda.cwiseAbs()).norm() + 2 * there.norm()),
        "the error of the constraint forces");
  }
}

void rod_forces(Trial& trial) {
  expect_forces(trial, chains(trial.random));
}

void wire_forces(Trial& trial) {
  expect_forces(trial, beads(trial.random));
}

// A product with the matrix, twice into buffers that hold junk.
VectorXd product(Trial& trial, const ConstrainedSystem& system, const VectorXd& multiplier, double junk) {
  MessageReader reply = ask(trial, kMatrix, system, {multiplier, VectorXd::Constant(system.rows(), junk)});
  const VectorXd first = get_vector(reply, system.rows());
  trial.expect(get_vector(reply, system.rows()) == multiplier, "the matrix's product changes its input");
  trial.expect(get_vector(reply, system.rows()) == first || !first.allFinite(),
               "the matrix gives another product the second time");
  reply.expect_end();
  return first;
}

void expect_matrix(Trial& trial, const ConstrainedSystem& system) {
  for (double junk : {0.0, kNaN}) {
    const VectorXd multiplier = random_vector(trial.random, system.rows());
    trial.expect_at_most((product(trial, system, multiplier, junk) - system.matrix() * multiplier).norm(),
                         2 * (16 + system.rows()) * kUnit * system.matrix_size() * multiplier.norm(),
                         "the error of a product with J W J'");
  }
}

void matrix(Trial& trial) {
  for (const ConstrainedSystem& system : chains(trial.random)) expect_matrix(trial, system);

  const ConstrainedSystem system = random_chain(trial.random, 5);
  const VectorXd a = random_vector(trial.random, system.rows()),
                 b = random_vector(trial.random, system.rows());
  const VectorXd Ab = product(trial, system, b, 0);
  const double rounding = 4 * (16 + system.rows()) * kUnit * system.matrix_size() * a.norm() * b.norm();
  trial.expect_at_most(std::abs(a.dot(Ab) - b.dot(product(trial, system, a, 0))), rounding,
                       "the asymmetry of J W J'");
}

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

// All particles turn and fly as one body does: such velocities keep all lengths.
void move_rigidly(Random& random, ConstrainedSystem& system) {
  const VectorXd motion = random_vector(random, 6);
  const Vector3d spin = motion.head<3>(), flight = motion.tail<3>();
  for (int i = 0; i < system.n(); ++i)
    system.state.v.segment<3>(3 * i) = flight + spin.cross(Vector3d(system.state.x.segment<3>(3 * i)));
}

// All distances of so many particles.
ConstrainedSystem rigid_body(Random& random, int n) {
  ConstrainedSystem body = random_chain(random, n);
  body.name = "rigid body";
  body.constraints = {};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < i; ++j) body.constraints.rods.push_back({i, j, 1});
  return held(body);
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

// Accelerations of the particles: with A = J W J' and any solution s, the difference of accelerations in the
// norm of the masses is that of lambda in the norm of A, at most residual / sqrt(A's smallest eigenvalue that
// is not 0).
void expect_same_accelerations(Trial& trial, const ConstrainedSystem& system) {
  const VectorXd lambda = solve(trial, system).lambda;
  const MatrixXd A = system.matrix();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(A);
  const double zero = 1e-10 * eigen.eigenvalues().maxCoeff();
  const VectorXd rhs = system.right_hand_side();
  VectorXd solution = VectorXd::Zero(system.rows());
  double smallest = eigen.eigenvalues().maxCoeff();
  for (int i = 0; i < system.rows(); ++i) {
    const double eigenvalue = eigen.eigenvalues()[i];
    if (eigenvalue < zero) continue;
    smallest = std::min(smallest, eigenvalue);
    solution += eigen.eigenvectors().col(i) * (eigen.eigenvectors().col(i).dot(rhs) / eigenvalue);
  }
  const VectorXd root = system.inverse_masses().cwiseSqrt();
  const VectorXd difference = root.cwiseProduct(system.jacobian().transpose() * (lambda - solution));
  trial.expect_at_most(difference.norm(),
                       (kTolerance * rhs.norm() + system.residual_rounding(lambda)) / std::sqrt(smallest),
                       "the error of the accelerations");
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
}

// What the student's lambda makes of the particles, for an integrator.
class StudentsDynamics : public particles::Dynamics {
 public:
  StudentsDynamics(Trial& trial, ConstrainedSystem system) : trial_(trial), system_(std::move(system)) {}

  void acceleration(particles::Input x, particles::Input v, particles::Output a) override {
    system_.state = {x, v};
    const VectorXd lambda = solve(trial_, system_).lambda;
    a = system_.inverse_masses().cwiseProduct(system_.f + system_.jacobian().transpose() * lambda);
  }

 private:
  Trial& trial_;
  ConstrainedSystem system_;
};

// A double pendulum, swung for 0.1 s. Nothing is faster than w = 20/s here, so that RK4 is off by at most 25
// steps of (h w)^5 / 120 = 7e-7 of all sizes. Its masses differ and its rods are pulled, so that what goes
// wrong shows.
void energy(Trial& trial) {
  Random& random = trial.random;
  const double g = 9.81;
  ConstrainedSystem swing = random_chain(random, 3);
  swing.name = "double pendulum";
  swing.particles.mass = Vector3d(1, random.uniform(2, 4), random.uniform(0.2, 0.4));
  swing.particles.pinned[0] = 1;
  const double turn = random.uniform(0, 6);
  for (int i = 1; i < 3; ++i) {
    const double down = random.uniform(0.3, 0.8);
    swing.state.x.segment<3>(3 * i) =
        swing.state.x.segment<3>(3 * i - 3) +
        random.uniform(0.7, 1.3) * Vector3d(std::sin(down) * std::cos(turn * i),
                                            std::sin(down) * std::sin(turn * i), -std::cos(down));
  }
  const Vector3d spin = random.uniform(1, 3) * Vector3d(std::sin(turn), std::cos(turn), 0);
  for (int i = 0; i < 3; ++i)
    swing.state.v.segment<3>(3 * i) =
        spin.cross(Vector3d(swing.state.x.segment<3>(3 * i) - swing.state.x.head<3>()));
  swing = held(swing);
  swing.f.setZero();
  for (int i = 0; i < 3; ++i) swing.f[3 * i + 2] = -g * swing.particles.mass[i];

  const auto energy = [&] {
    double sum = -swing.f.dot(swing.state.x);
    for (int i = 0; i < 3; ++i)
      sum += 0.5 * swing.particles.mass[i] * swing.state.v.segment<3>(3 * i).squaredNorm();
    return sum;
  };
  const double before = energy();
  StudentsDynamics dynamics(trial, swing);
  MatrixXd scratch(9, particles::kIntegratorScratch);
  for (int step = 0; step < 25; ++step)
    particles::runge_kutta_4(dynamics, 0.004, swing.state.x, swing.state.v, scratch);
  const double scale = g * swing.particles.mass.tail<2>().sum();
  trial.expect_at_most(std::abs(energy() - before), kTolerance * scale,
                       "the energy that a swing gains or loses");
  trial.expect_at_most(swing.values().norm(), kTolerance, "what a swing's rods are off their lengths");
}

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

void tolerance_and_report(Trial& trial) {
  Random& random = trial.random;
  // Forces of 1e30 N tell a residual from its square, which for small ones is lost in rounding.
  for (const auto& [n, scale] : {std::pair{2, 1.0}, {3, 1.0}, {10, 1.0}, {30, 1.0}, {10, 1e30}}) {
    ConstrainedSystem system = at_rest(held(random_chain(random, n)));
    system.f *= scale;
    const Solved solved = solve(trial, system);
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
  ConstrainedSystem none = random_chain(random, 3);
  none.name = "no constraints";
  none.constraints = {};
  const Solved nothing = solve(trial, none);
  trial.expect(nothing.steps == 0 && nothing.residual == 0, "no constraints take steps, or leave a residual");

  // Two lengths for one rod: it ends, and does not claim a solution. The difference of the two rows'
  // right-hand sides over sqrt(2), here 50 and more, is in the way of any.
  ConstrainedSystem both = at_rest(held(random_chain(random, 3)));
  both.name = "two lengths";
  both.constraints.rods.push_back(both.constraints.rods[0]);
  both.constraints.rods.back().length += 1;
  both.constraints.stiffness = 100;
  const VectorXd rhs = both.right_hand_side();
  const double least = std::abs(rhs[0] - rhs[2]) / std::sqrt(2.0), reported = solve(trial, both).residual;
  trial.expect(!(reported < 0.99 * least), "constraints that contradict each other are reported as solved",
               std::to_string(reported));
}

}  // namespace

std::vector<Category> categories() {
  return {{"RodValues", "Values and rates of rods", 2, rod_values},
          {"WireValues", "Values and rates of wires", 2, wire_values},
          {"RodForces", "Forces of rods", 1, rod_forces},
          {"WireForces", "Forces of wires", 1, wire_forces},
          {"Matrix", "The matrix", 1, matrix},
          {"AtRest", "Particles at rest", 1, particles_at_rest},
          {"Moving", "Particles that move", 1, particles_that_move},
          {"Wires", "Beads on wires", 1, beads_on_wires},
          {"Feedback", "Feedback", 1, feedback},
          {"Pinned", "Pinned particles", 1, pinned_particles},
          {"Redundant", "Redundant constraints", 1, redundant},
          {"Energy", "Energy in a swing", 1, energy},
          {"Report", "Tolerance and report", 1, tolerance_and_report}};
}

}  // namespace grader::p2
