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
#include "grader/wire/strand_message.h"
#include "particles/explicit_integrators.h"

namespace grader::p2 {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kUnit = 0x1p-53;
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
                   double tolerance = 1e-6) {
  trial.expect_at_most(true_residual(system, lambda),
                       tolerance * system.right_hand_side().norm() + system.residual_rounding(lambda),
                       "what is left of the constraints' acceleration");
}

// The same system where nothing moves.
ConstrainedSystem at_rest(ConstrainedSystem system) {
  system.state.v.setZero();
  return system;
}

// Chains, rods alone, wires alone; none of them redundant.
std::vector<ConstrainedSystem> ordinary_systems(Random& random) {
  std::vector<ConstrainedSystem> systems;
  for (int n : {1, 2, 3, random.integer(5, 15)}) systems.push_back(random_chain(random, n));
  systems.push_back(random_chain(random, 6));
  systems.back().name = "rods alone";
  systems.back().constraints.wires.clear();
  systems.push_back(random_chain(random, 4));
  systems.back().name = "wires alone";
  systems.back().constraints.rods.clear();
  for (int i : {2, 3, 1}) {
    particles::Wire wire = systems.back().constraints.wires[0];
    wire.i = i;
    systems.back().constraints.wires.push_back(wire);
  }
  return systems;
}

void values(Trial& trial) {
  for (const ConstrainedSystem& system : ordinary_systems(trial.random))
    for (double junk : {0.0, kNaN})
      trial.expect_at_most(
          (answer(trial, kValues, system, {VectorXd::Constant(system.rows(), junk)}, system.rows()) -
           system.values())
              .norm(),
          32 * kUnit * system.value_size(), "the error of C");
}

void rates(Trial& trial) {
  for (const ConstrainedSystem& system : ordinary_systems(trial.random))
    for (double junk : {0.0, kNaN}) {
      const MatrixXd J = system.jacobian();
      const VectorXd rates =
          answer(trial, kRates, system, {VectorXd::Constant(system.rows(), junk)}, system.rows());
      trial.expect_at_most((rates - J * system.state.v).norm(),
                           32 * kUnit * (J.cwiseAbs() * system.state.v.cwiseAbs()).norm(),
                           "the error of J v");
    }
}

void forces(Trial& trial) {
  for (const ConstrainedSystem& system : ordinary_systems(trial.random)) {
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
  for (const ConstrainedSystem& system : ordinary_systems(trial.random)) expect_matrix(trial, system);

  const ConstrainedSystem system = random_chain(trial.random, 5);
  const VectorXd a = random_vector(trial.random, system.rows()),
                 b = random_vector(trial.random, system.rows());
  const VectorXd Ab = product(trial, system, b, 0);
  const double rounding = 4 * (16 + system.rows()) * kUnit * system.matrix_size() * a.norm() * b.norm();
  trial.expect_at_most(std::abs(a.dot(Ab) - b.dot(product(trial, system, a, 0))), rounding,
                       "the asymmetry of J W J'");
}

// J W f is all of the right-hand side, and so nothing moves off the constraints.
void particles_at_rest(Trial& trial) {
  for (const ConstrainedSystem& system : ordinary_systems(trial.random)) {
    ConstrainedSystem resting = at_rest(held(system));
    expect_solved(trial, resting, solve(trial, resting).lambda);
  }
  // Hair: masses of 1e-8 kg and segments of a centimetre.
  ConstrainedSystem hair = at_rest(held(random_chain(trial.random, 8)));
  hair.name = "hair";
  hair.particles.mass *= 1e-8;
  hair.f *= 1e-8;
  hair.state.x *= 0.01;
  for (particles::Wire& wire : hair.constraints.wires) wire.centre *= 0.01;
  hair = held(hair);
  expect_solved(trial, hair, solve(trial, hair).lambda);
}

void particles_that_move(Trial& trial) {
  Random& random = trial.random;
  for (ConstrainedSystem system : ordinary_systems(random))
    expect_solved(trial, held(system), solve(trial, held(system)).lambda);

  // A bead on a wire without any force keeps its speed: the wire turns it with m v^2 / r.
  ConstrainedSystem bead = held(random_chain(random, 1));
  bead.name = "bead";
  bead.f.setZero();
  const particles::Wire& wire = bead.constraints.wires[0];
  const Vector3d d = bead.state.x - wire.centre;
  const double speed = random.uniform(1, 3);
  bead.state.v = speed * wire.normal.cross(d).normalized();
  const VectorXd lambda = solve(trial, bead).lambda;
  const double expected = bead.particles.mass[0] * speed * speed / (wire.radius * wire.radius);
  // The matrix is diag(r^2, 1) / m.
  trial.expect_at_most(std::abs(lambda[0] + expected), 1e-5 * expected, "the error of a bead's lambda");
}

// Feedback adds -stiffness C - damping J v to the right-hand side, and so what solves that to lambda: the
// difference of two solves.
void feedback(Trial& trial) {
  Random& random = trial.random;
  for (const ConstrainedSystem& plain : ordinary_systems(random))
    for (const auto& [stiffness, damping] :
         {std::pair{random.uniform(10, 1000), 0.0}, {0.0, random.uniform(1, 50)}, {100.0, 20.0}}) {
      ConstrainedSystem with = plain;
      with.constraints.stiffness = stiffness;
      with.constraints.damping = damping;
      const VectorXd lambda = solve(trial, with).lambda, without = solve(trial, plain).lambda;
      const VectorXd expected = with.right_hand_side() - plain.right_hand_side();
      trial.expect_at_most((expected - plain.matrix() * (lambda - without)).norm(),
                           1e-6 * (with.right_hand_side().norm() + plain.right_hand_side().norm()) +
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
    system.constraints.wires.clear();
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
  trial.expect_at_most(std::abs(solve(trial, pendulum).lambda[0] + expected), 1e-5 * expected,
                       "the error of a pendulum's lambda");
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
                       (1e-6 * rhs.norm() + system.residual_rounding(lambda)) / std::sqrt(smallest),
                       "the error of the accelerations");
}

// All particles turn and fly as one body does: such velocities keep all lengths.
void move_rigidly(Random& random, ConstrainedSystem& system) {
  const VectorXd motion = random_vector(random, 6);
  const Vector3d spin = motion.head<3>(), flight = motion.tail<3>();
  for (int i = 0; i < system.n(); ++i)
    system.state.v.segment<3>(3 * i) = flight + spin.cross(Vector3d(system.state.x.segment<3>(3 * i)));
}

void redundant(Trial& trial) {
  Random& random = trial.random;
  // Rods twice and three times, either end first.
  ConstrainedSystem twice = random_chain(random, 5);
  twice.name = "rods twice";
  for (int k = 0; k < 4; ++k) {
    const particles::Rod rod = twice.constraints.rods[k];
    twice.constraints.rods.push_back({rod.j, rod.i, rod.length});
  }
  twice.constraints.rods.push_back(twice.constraints.rods[0]);
  twice.constraints.stiffness = 50;
  twice.constraints.damping = 10;
  expect_same_accelerations(trial, twice);

  // A wire, and a rod from its pinned centre.
  ConstrainedSystem bead = held(random_chain(random, 2));
  bead.name = "wire and rod";
  bead.particles.pinned[1] = 1;
  bead.state.x.tail<3>() = bead.constraints.wires[0].centre;
  bead.state.v.tail<3>().setZero();
  expect_same_accelerations(trial, held(bead));

  // Six particles, all fifteen distances: three more than a rigid body needs.
  ConstrainedSystem body = random_chain(random, 6);
  body.name = "rigid body";
  body.constraints = {};
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < i; ++j) body.constraints.rods.push_back({i, j, 1});
  move_rigidly(random, body);
  expect_same_accelerations(trial, held(body));

  // Rods that hold nothing: between pinned particles, and of length 0.
  ConstrainedSystem nothing = held(random_chain(random, 5));
  nothing.name = "rods that hold nothing";
  nothing.constraints.wires.clear();
  nothing.particles.pinned[0] = nothing.particles.pinned[1] = 1;
  nothing.state.v.head<6>().setZero();
  nothing.state.x.segment<3>(9) = nothing.state.x.segment<3>(6);
  nothing.state.v.segment<3>(9) = nothing.state.v.segment<3>(6);
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

// A bead on an upright wire, a rod hanging from it, swung for 0.1 s. Nothing is faster than w = 20/s here, so
// that RK4 is off by at most 25 steps of (h w)^5 / 120 = 1.1e-7 of all sizes.
void energy(Trial& trial) {
  Random& random = trial.random;
  const double radius = random.uniform(0.8, 1.2), length = random.uniform(0.8, 1.2),
               angle = random.uniform(0.5, 1), g = 9.81;
  ConstrainedSystem swing;
  swing.name = "swing";
  swing.particles = {Eigen::Vector2d(random.uniform(0.5, 2), random.uniform(0.5, 2)), {0, 0}};
  const VectorXd& mass = swing.particles.mass;
  swing.constraints.wires = {{0, Vector3d::Zero(), Vector3d(0, 1, 0), radius}};
  swing.constraints.rods = {{0, 1, length}};
  swing.state = {VectorXd::Zero(6), VectorXd::Zero(6)};
  swing.state.x.head<3>() = radius * Vector3d(std::sin(angle), 0, -std::cos(angle));
  swing.state.x.tail<3>() = swing.state.x.head<3>() + length * Vector3d(0.6, 0, -0.8);
  swing.state.v.tail<3>() = random.uniform(1, 3) * Vector3d(0, 1, 0);
  swing.f = VectorXd::Zero(6);
  swing.f[2] = -g * mass[0];
  swing.f[5] = -g * mass[1];

  const auto energy = [&] {
    const VectorXd &x = swing.state.x, &v = swing.state.v;
    return 0.5 * mass[0] * v.head<3>().squaredNorm() + 0.5 * mass[1] * v.tail<3>().squaredNorm() +
           g * (mass[0] * x[2] + mass[1] * x[5]);
  };
  const double before = energy(), scale = mass.sum() * g * (radius + length);
  StudentsDynamics dynamics(trial, swing);
  MatrixXd scratch(6, particles::kIntegratorScratch);
  for (int step = 0; step < 25; ++step)
    particles::runge_kutta_4(dynamics, 0.004, swing.state.x, swing.state.v, scratch);
  trial.expect_at_most(std::abs(energy() - before), 1e-5 * scale, "the energy that a swing gains or loses");
  trial.expect_at_most(swing.values().norm(), 1e-5, "what a swing is off its wire and its rod");
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
  for (int n : {1, 2, 10, 30}) {
    ConstrainedSystem system = random_chain(random, n);
    system.constraints.stiffness = 30;
    system.constraints.damping = 10;
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

  // Two lengths for one rod: it ends, and does not claim to have a solution. Half of the difference of the
  // two rows' right-hand sides is in the way of any.
  ConstrainedSystem both = random_chain(random, 3);
  both.name = "two lengths";
  both.constraints.rods.push_back(both.constraints.rods[0]);
  both.constraints.rods.back().length += 1;
  both.constraints.stiffness = 100;
  const Solved torn = solve(trial, both);
  const VectorXd rhs = both.right_hand_side();
  trial.expect(torn.residual >= 0.99 * std::abs(rhs[0] - rhs[2]) / std::sqrt(2.0),
               "constraints that contradict each other are reported as solved",
               std::to_string(torn.residual));
}

}  // namespace

std::vector<Category> categories() {
  return {{"Values", "Constraint values", 2, values},
          {"Rates", "Constraint rates", 2, rates},
          {"Forces", "Forces from multipliers", 2, forces},
          {"Matrix", "The matrix", 2, matrix},
          {"AtRest", "Particles at rest", 1, particles_at_rest},
          {"Moving", "Particles that move", 1, particles_that_move},
          {"Feedback", "Feedback", 1, feedback},
          {"Pinned", "Pinned particles", 1, pinned_particles},
          {"Redundant", "Redundant constraints", 1, redundant},
          {"Energy", "Energy in a swing", 1, energy},
          {"Report", "Tolerance and report", 1, tolerance_and_report}};
}

}  // namespace grader::p2
