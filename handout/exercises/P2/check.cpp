// The public checks of P2. Every failure prints the input, what was expected, what came, the error and its
// bound. The contract is in particles/constraint_forces.h. The checks of solve_constraints need S1: it calls
// your ConjGrad.

#include "particles/constraint_forces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <utility>

#include "check.h"
#include "derivative.h"
#include "ordinary.h"

using namespace checks;
using namespace particles;
using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

namespace {

const double kUnit = std::ldexp(1.0, -53), kNaN = std::numeric_limits<double>::quiet_NaN();

struct Example {
  Constraints constraints;
  Particles particles;
  State state;
  VectorXd f;
};

// Particle 1 hangs from particle 0, which is pinned, on a rod of 0.5 m: mass 2 kg, angle 0.5 to the side.
Example pendulum() {
  Example system;
  system.constraints.rods = {{1, 0, 0.5}};
  system.particles = {Vector2d(3, 2), {1, 0}};
  system.state = {VectorXd::Zero(6), VectorXd::Zero(6)};
  system.state.x.tail<3>() = 0.5 * Vector3d(std::sin(0.5), 0, -std::cos(0.5));
  system.f = VectorXd::Zero(6);
  system.f[5] = -9.81 * 2;
  return system;
}

// A bead of 0.25 kg on a level wire of radius 2 around (1, 0, 3).
Example bead() {
  Example system;
  system.constraints.wires = {{0, Vector3d(1, 0, 3), Vector3d(0, 0, 1), 2}};
  system.particles = {VectorXd::Constant(1, 0.25), {0}};
  system.state = {Vector3d(1, 2, 3), Vector3d::Zero()};
  system.f = Vector3d(0, 0, -9.81 * 0.25);
  return system;
}

// Five particles without a pattern, four rods between them and two wires. No constraint holds.
Example tangle() {
  Example system;
  Scatter scatter(2);
  const Vector3d first = ordinary_direction(scatter), second = ordinary_direction(scatter);
  system.constraints.rods = {{0, 1, 0.7}, {2, 1, 1.1}, {3, 2, 0.9}, {1, 4, 0.4}};
  system.constraints.wires = {{3, Vector3d(0.2, -1, 0.5), first, 0.8},
                              {0, Vector3d(-1, 0.3, 0.1), second, 1.5}};
  system.particles = {(VectorXd(5) << 0.3, 2, 0.7, 5, 1.1).finished(), {0, 0, 0, 0, 1}};
  system.state = {scattered_vector(15, 1), scattered_vector(15, 2)};
  system.f = scattered_vector(15, 3);
  return system;
}

VectorXd values(const Example& system, const VectorXd& x) {
  VectorXd C = VectorXd::Constant(system.constraints.rows(), kNaN);
  constraint_values(system.constraints, x, C);
  return C;
}

VectorXd rates(const Example& system, const VectorXd& v) {
  VectorXd result = VectorXd::Constant(system.constraints.rows(), kNaN);
  constraint_rates(system.constraints, system.state.x, v, result);
  return result;
}

VectorXd forces(const Example& system, const VectorXd& lambda) {
  VectorXd f = VectorXd::Zero(system.state.x.size());
  add_constraint_forces(system.constraints, system.state.x, lambda, f);
  return f;
}

VectorXd product(const Example& system, VectorXd y) {
  VectorXd result = VectorXd::Constant(y.size(), kNaN);
  constraint_matrix(system.constraints, system.particles, system.state)->matVecMult(y.data(), result.data());
  return result;
}

VectorXd solve(const Example& system) {
  VectorXd lambda = VectorXd::Constant(system.constraints.rows(), 1e3);
  solve_constraints(system.constraints, system.particles, system.state, system.f, lambda);
  return lambda;
}

// W (f + J^T lambda).
VectorXd accelerations(const Example& system) {
  VectorXd a = system.f + forces(system, solve(system));
  for (int i = 0; i < system.particles.count(); ++i)
    a.segment<3>(3 * i) *= system.particles.is_pinned(i) ? 0 : 1 / system.particles.mass[i];
  return a;
}

// Powers of two change no digit.
const double kSmallUnit = std::ldexp(1.0, -40);

// Rods alone, all lengths times `unit`.
Example four_rods(double unit) {
  Example rods = tangle();
  rods.constraints.wires.clear();
  for (Rod& rod : rods.constraints.rods) rod.length *= unit;
  rods.state.x *= unit;
  return rods;
}

}  // namespace

TEST(RodValues, OfARodAreHalfTheDifferenceOfSquares) {
  Example system = pendulum();
  VectorXd x(6);
  x << 0.5, -1, 3, 1.5, 1, 5;
  expect_numbers(values(system, x), VectorXd::Constant(1, (9 - 0.25) / 2), 0,
                 "rod of length 0.5 between (0.5, -1, 3) and (1.5, 1, 5)", "these numbers are exact");
}

TEST(WireValues, OfAWireAreItsSphereAndItsPlane) {
  expect_numbers(values(bead(), Vector3d(1, 2, 3)), Vector2d(0, 0), 0, "a bead on its wire", "exact");
  expect_numbers(values(bead(), Vector3d(1, 0, 5)), Vector2d(0, 2), 0,
                 "a bead on the sphere of radius 2 around (1, 0, 3), above its pole", "exact");
  expect_numbers(values(bead(), Vector3d(4, 0, 3)), Vector2d(2.5, 0), 0,
                 "a bead in the plane, 3 from the centre", "exact");
  Example tilted = bead();
  tilted.constraints.wires[0].normal = Vector3d(2, 3, 6) / 7;
  expect_numbers(values(tilted, Vector3d(3, 4, 4)), Vector2d(8.5, 22.0 / 7), 16 * kUnit,
                 "a bead (2, 4, 1) from the centre, the wire's normal is (2, 3, 6) / 7");
}

TEST(Rows, ComeRodsFirst) {
  const Example system = tangle();
  const VectorXd C = values(system, system.state.x);
  ASSERT_EQ(C.size(), 8);
  EXPECT_TRUE(C.allFinite()) << "all rows are overwritten; C = " << C.transpose();
  Example rods = system;
  rods.constraints.wires.clear();
  expect_numbers(C.head<4>(), values(rods, rods.state.x), 0, "the first four rows, of four rods",
                 "the same numbers");
}

TEST(Units, HaveNoUnitOfTheirOwnByConstraintValues) {
  const Example metres = four_rods(1), other = four_rods(kSmallUnit);
  expect_numbers(values(other, other.state.x), kSmallUnit * kSmallUnit * values(metres, metres.state.x), 0,
                 "C of four rods, all lengths times 2^-40", "exact");
}

TEST(RodValues, AreTheChangeOfTheValues) {
  const Example system = tangle();
  const double h = std::ldexp(1.0, -14);
  const VectorXd v = system.state.v;
  const VectorXd expected =
      (values(system, system.state.x + h * v) - values(system, system.state.x - h * v)) / (2 * h);
  expect_numbers(rates(system, v), expected, 1e-10,
                 "J v against (C(x + h v) - C(x - h v)) / 2h of your own constraint_values, h = 2^-14",
                 "C is quadratic, so that only rounding is left: 16 u / h, u = 2^-53");
}

TEST(RodValues, OfASpinAreZero) {
  // Turning around the pivot, and around the wire's axis.
  expect_numbers(rates(pendulum(), (VectorXd(6) << 0, 0, 0, std::cos(0.5), 0, std::sin(0.5)).finished()),
                 VectorXd::Zero(1), 8 * kUnit, "a pendulum that swings");
  expect_numbers(rates(bead(), Vector3d(-7, 0, 0)), Vector2d(0, 0), 0, "a bead that slides", "exact");
}

TEST(Units, HaveNoUnitOfTheirOwnByConstraintRates) {
  const Example metres = four_rods(1), other = four_rods(kSmallUnit);
  const VectorXd v = metres.state.v;
  expect_numbers(rates(other, v), kSmallUnit * rates(metres, v), 0,
                 "J v of four rods, all lengths times 2^-40", "exact");
}

// (J^T lambda) . v against lambda . (J v).
void expect_transpose(const Example& system) {
  const VectorXd lambda = scattered_vector(system.constraints.rows(), 4), v = system.state.v;
  EXPECT_NUMBER(forces(system, lambda).dot(v), lambda.dot(rates(system, v)), 1e-14)
      << "(J^T lambda) . v against lambda . (J v), lambda = " << lambda.transpose()
      << "; bound: some 50 roundings of numbers about 1";
}

TEST(RodForces, AreTheTransposeOfTheRates) {
  Example system = tangle();
  system.constraints.wires.clear();
  expect_transpose(system);
}

TEST(RodForces, OfRodsAreEqualAndOpposite) {
  Example system = tangle();
  system.constraints.wires.clear();
  expect_balanced(forces(system, scattered_vector(4, 4)), system.state.x, 50 * kUnit,
                  "50 roundings of numbers about 1");
}

TEST(WireForces, AreTheTransposeOfTheRates) {
  expect_transpose(tangle());
}

TEST(RodForces, AreAddedToWhatIsThere) {
  const Example system = tangle();
  const VectorXd lambda = scattered_vector(8, 4), there = VectorXd::Constant(15, 8);
  VectorXd f = there;
  add_constraint_forces(system.constraints, system.state.x, lambda, f);
  expect_numbers(f, there + forces(system, lambda), 100 * kUnit, "f, which held 8s",
                 "10 roundings of numbers about 10");
}

TEST(Units, HaveNoUnitOfTheirOwnByConstraintForces) {
  const Example metres = four_rods(1), other = four_rods(kSmallUnit);
  const VectorXd lambda = scattered_vector(4, 4);
  expect_numbers(forces(other, lambda), kSmallUnit * forces(metres, lambda), 0,
                 "J^T lambda of four rods, all lengths times 2^-40", "exact");
}

TEST(Matrix, IsTheTableOfItsProducts) {
  const Example system = tangle();
  const int rows = system.constraints.rows();
  for (int k = 0; k < rows; ++k) {
    SCOPED_TRACE("column " + std::to_string(k));
    const VectorXd unit = VectorXd::Unit(rows, k);
    VectorXd change = forces(system, unit);
    for (int i = 0; i < 5; ++i) change.segment<3>(3 * i) *= i == 4 ? 0 : 1 / system.particles.mass[i];
    expect_numbers(
        product(system, unit), rates(system, change), 1e-13,
        "J W J^T e_k, compared with your own rates of W times your own forces; particle 4 is pinned",
        "some 50 roundings of numbers up to 10");
  }
}

TEST(Matrix, UsesTheValuesOfNow) {
  Example system = tangle();
  VectorXd y = scattered_vector(8, 7), result(8);
  const auto matrix = constraint_matrix(system.constraints, system.particles, system.state);
  system.state.x *= 1.5;
  system.particles.mass *= 2;
  std::swap(system.constraints.rods[0], system.constraints.rods[2]);
  matrix->matVecMult(y.data(), result.data());
  expect_numbers(result, product(system, y), 1e-13,
                 "a product with the matrix that was made before positions, masses and rods changed, against "
                 "that with a new one",
                 "some 50 roundings of numbers up to 10");
}

TEST(Matrix, IsSymmetricAndNeverNegative) {
  const Example system = tangle();
  const VectorXd a = scattered_vector(8, 5), b = scattered_vector(8, 6);
  expect_symmetric([&](const VectorXd& y) { return product(system, y); }, a, b, 1e-12, "some 100 roundings");
  EXPECT_GT(a.dot(product(system, a)), 0);
}

TEST(Pinned, OfPinnedParticlesIsZero) {
  Example system = pendulum();
  system.particles.pinned = {1, 1};
  expect_numbers(product(system, VectorXd::Ones(1)), VectorXd::Zero(1), 0, "a rod between pinned particles",
                 "0 is exact");
}

TEST(Solve, CarriesAPendulum) {
  Example system = pendulum();
  // At rest the rod pulls with m g cos(angle); in a swing of 3 m/s with m v^2 / length more.
  const double pull = 2 * 9.81 * std::cos(0.5);
  expect_numbers(solve(system), VectorXd::Constant(1, -pull / 0.5), 1e-8 * pull, "lambda at rest",
                 "the tolerance, 1e-10, with room");
  system.state.v.tail<3>() = 3 * Vector3d(std::cos(0.5), 0, std::sin(0.5));
  expect_numbers(solve(system), VectorXd::Constant(1, -(pull + 2 * 9 / 0.5) / 0.5), 1e-8 * (pull + 36),
                 "lambda at 3 m/s", "the tolerance, 1e-10, with room");
}

TEST(Pinned, TakesAPivotsVelocityAsItIs) {
  Example resting = pendulum(), flying = pendulum();
  flying.state.v << 3, 1, -2, 3, 1, -2;
  expect_numbers(solve(flying), solve(resting), 1e-8 * solve(resting).norm(),
                 "lambda of a pendulum whose pinned end moves at (3, 1, -2) m/s, and the other as fast",
                 "nothing turns, so it is that at rest; the tolerance, 1e-10, with room");
}

TEST(Units, HasNoUnitOfItsOwn) {
  Example metres = pendulum(), other = pendulum();
  const double unit = std::ldexp(1.0, -40);
  other.constraints.rods[0].length *= unit;
  other.state.x *= unit;
  other.f *= unit;
  expect_numbers(solve(other), solve(metres), 1e-8 * solve(metres).norm(),
                 "lambda of a pendulum, all lengths and forces times 2^-40",
                 "the tolerance, 1e-10, with room");
}

TEST(Solve, HoldsABead) {
  Example system = bead();
  system.state.v = Vector3d(-4, 0, 0);
  const Vector2d expected(-0.25 * 16 / 2 / 2, 9.81 * 0.25);
  expect_numbers(solve(system), expected, 1e-8 * expected.norm(),
                 "lambda of a bead at 4 m/s on a level wire of radius 2: (-m v^2 / r^2, m g)",
                 "the tolerance, 1e-10, with room");
}

TEST(Solve, LeavesConstraintsNoAcceleration) {
  const Example system = tangle();
  // C'' = J a + J' v by differences of J v along the motion x + t v + t^2/2 a.
  const VectorXd a = accelerations(system), v = system.state.v;
  const double h = std::ldexp(1.0, -14);
  const auto rates_at = [&](double t) {
    Example moved = system;
    moved.state.x += t * v + t * t / 2 * a;
    return rates(moved, v + t * a);
  };
  expect_numbers((rates_at(h) - rates_at(-h)) / (2 * h), VectorXd::Zero(8), 1e-6,
                 "C'' of the moving system, by differences of your own constraint_rates, h = 2^-14",
                 "h^2 times fourth derivatives of C, about 3 |a|^2, |a| about 5: 3e-7");
}

TEST(Feedback, FeedsErrorsBack) {
  Example system = tangle();
  system.constraints.stiffness = 40;
  system.constraints.damping = 6;
  const VectorXd a = accelerations(system), v = system.state.v;
  const VectorXd expected = -40 * values(system, system.state.x) - 6 * rates(system, v);
  // J' v as a difference of rates, since the part of the rates that depends on x is linear in x.
  Example moved = system, still = system;
  moved.state.x += v;
  const VectorXd curvature = rates(moved, v) - rates(still, v);
  expect_numbers(rates(system, a) + curvature, expected, 1e-8 * expected.norm(),
                 "C'' = J a + J' v against -stiffness C - damping C'", "the tolerance, 1e-10, with room");
}

TEST(Solve, SharesTheForceOfARodThatIsThereTwice) {
  Example once = pendulum(), twice = pendulum();
  twice.constraints.rods.push_back({0, 1, 0.5});
  expect_numbers(forces(twice, solve(twice)).tail<3>(), forces(once, solve(once)).tail<3>(), 1e-8 * 9.81 * 2,
                 "the force on a pendulum with the same rod twice", "the tolerance, 1e-10, with room");
}

TEST(Nothing, LeavesAlonePartsThatNothingPullsApart) {
  // A braced rectangle of 0.375 by 0.5 m: six rods, one more than hold its shape in its plane. All particles
  // move at the same speed, and all fall alike: each term of the right-hand side is exactly 0 in these
  // numbers.
  Example falling;
  falling.particles = {Eigen::Vector4d(1, 0.5, 2, 0.25), {0, 0, 0, 0}};
  falling.state = {VectorXd(12), Vector3d(1, -2, 0.5).replicate(4, 1)};
  falling.state.x << 0, 0, 0, 0.375, 0, 0, 0.375, 0, -0.5, 0, 0, -0.5;
  falling.f = VectorXd::Zero(12);
  for (int i = 0; i < 4; ++i) falling.f[3 * i + 2] = -8 * falling.particles.mass[i];
  falling.constraints.rods = {{0, 1, 0.375}, {1, 2, 0.5},   {2, 3, 0.375},
                              {3, 0, 0.5},   {0, 2, 0.625}, {1, 3, 0.625}};
  falling.constraints.stiffness = 400;
  falling.constraints.damping = 40;
  VectorXd lambda = VectorXd::Constant(6, 1e3);
  const ConstraintReport report =
      solve_constraints(falling.constraints, falling.particles, falling.state, falling.f, lambda);
  expect_numbers(lambda, VectorXd::Zero(6), 0,
                 "lambda of a braced rectangle that falls, where nothing is to be done", "0 is exact");
  EXPECT_NUMBER(report.residual, 0, 0);
}

TEST(Report, ReportsHowFarItCame) {
  const Example system = tangle();
  VectorXd lambda(8);
  const ConstraintReport report =
      solve_constraints(system.constraints, system.particles, system.state, system.f, lambda);
  EXPECT_GT(report.steps, 0);
  EXPECT_LE(report.residual, 1e-8)
      << "||right-hand side - J W J^T lambda||, for a right-hand side of about 10";
  Example pulled = system;
  pulled.f *= 1e6;
  const ConstraintReport large =
      solve_constraints(pulled.constraints, pulled.particles, pulled.state, pulled.f, lambda);
  EXPECT_LE(large.residual, 1.001e-10 * product(pulled, lambda).norm())
      << "the same with a million times the forces; bound: 1e-10 times the norm of the right-hand side, "
         "which is that of J W J^T lambda but for the residual";
  // Two free particles in one place, a rod of length 0 between them, and they part at 3 m/s: J = 0, so that
  // nothing can solve 0 = -J' v = -9, and all of it is left.
  Example apart = pendulum();
  apart.constraints.rods = {{1, 0, 0}};
  apart.particles.pinned = {0, 0};
  apart.state.x.setZero();
  apart.state.v << 0, 0, 0, 1, 2, 2;
  VectorXd any(1);
  EXPECT_NUMBER(solve_constraints(apart.constraints, apart.particles, apart.state, apart.f, any).residual, 9,
                16 * 9 * kUnit)
      << "the residual where the ends of a rod of length 0 part at 3 m/s: the norm of the right-hand side, "
         "and not "
         "its square; bound: rounding";
}

TEST(Report, ReportsTheStepsOfConjGrad) {
  // Two equal rods that share no particle: J W J^T is a multiple of the identity, and one step solves that.
  Example pair;
  pair.particles = {VectorXd::Constant(4, 1.7), {0, 0, 0, 0}};
  pair.state = {VectorXd::Zero(12), VectorXd::Zero(12)};
  pair.state.x[3] = pair.state.x[10] = 2;
  pair.f = scattered_vector(12, 8);
  pair.constraints.rods = {{0, 1, 2}, {2, 3, 2}};
  VectorXd lambda(2);
  EXPECT_COUNT(solve_constraints(pair.constraints, pair.particles, pair.state, pair.f, lambda).steps, 1);
}

TEST(Report, TakesTheStepsThatALongChainNeeds) {
  // 150 particles in a chain, the first one pinned: 149 rows, and hundreds of iterations.
  constexpr int kCount = 150;
  Scatter scatter(3);
  const hair::Strand strand = ordinary_strand(scatter, kCount);
  Example chain;
  chain.particles = {strand.mass, std::vector<char>(kCount, 0)};
  chain.particles.pinned[0] = 1;
  chain.state = {ordinary_positions(scatter, strand, 1, 1, 0.5), VectorXd::Zero(3 * kCount)};
  for (int i = 1; i < kCount; ++i) chain.constraints.rods.push_back({i - 1, i, strand.rest_length[i - 1]});
  chain.f = scattered_vector(3 * kCount, 4);
  VectorXd lambda(kCount - 1);
  const ConstraintReport report =
      solve_constraints(chain.constraints, chain.particles, chain.state, chain.f, lambda);
  EXPECT_LE(report.residual, 1.001e-10 * product(chain, lambda).norm())
      << "the residual after " << report.steps
      << " iterations; bound: 1e-10 times the norm of the right-hand side. The limit is max(100, 20 rows)";
}

TEST(Report, TakesAllStepsThereMayBeWhereNoneSuffice) {
  // 40 rods of 1 to 1e8 m that share no particle: their squares are the matrix's entries, and rounding leaves
  // more than the tolerance.
  constexpr int kRods = 40;
  Example system;
  system.particles = {VectorXd::Constant(2 * kRods, 1.7), std::vector<char>(2 * kRods, 0)};
  system.state = {VectorXd::Zero(6 * kRods), VectorXd::Zero(6 * kRods)};
  for (int i = 0; i < kRods; ++i) {
    const double length = std::pow(10, 8.0 * i / (kRods - 1));
    system.state.x[6 * i + 3] = length;
    system.constraints.rods.push_back({2 * i, 2 * i + 1, length});
  }
  system.f = scattered_vector(6 * kRods, 6);
  VectorXd lambda(kRods);
  const ConstraintReport report =
      solve_constraints(system.constraints, system.particles, system.state, system.f, lambda);
  if (report.residual > 1e-6 * product(system, lambda).norm()) {
    EXPECT_TRUE(report.steps > 0 && report.steps % 800 == 0)
        << report.steps
        << " steps for 40 rods of 1 to 1e8 m, which are not solved. Each call of ConjGrad may take "
        << "max(100, 20 rows) = 800, and you report the sum";
  }
}

TEST(Solve, GivesTheSameForcesHoweverOftenItIsAsked) {
  const Example system = tangle();
  const VectorXd first = solve(system);
  for (int i = 1; i <= kManyCalls; ++i)
    ASSERT_EQ(solve(system), first) << "lambda of the same system, asked again, " << i << " times so far";
}

int main(int argc, char** argv) {
  static const Example none;
  static VectorXd nothing;
  return run(argc, argv,
             {{"constraint_values", [] { constraint_values({}, nothing, nothing); }},
              {"constraint_rates", [] { constraint_rates({}, nothing, nothing, nothing); }},
              {"add_constraint_forces",
               [] { add_constraint_forces({}, nothing, nothing, nothing); },
               {"constraint_rates"}},
              {"constraint_matrix",
               [] { constraint_matrix(none.constraints, none.particles, none.state); },
               {"constraint_rates", "add_constraint_forces"}},
              {"solve_constraints",
               [] {
                 const Example system = pendulum();
                 VectorXd lambda(1);
                 solve_constraints(system.constraints, system.particles, system.state, system.f, lambda);
               },
               {"constraint_values", "constraint_rates", "add_constraint_forces", "constraint_matrix"}}});
}
