// STAFF ONLY. Energy and angular momentum that H6 loses: the public checks test the promises of
// hair/predictor_corrector.h. Rounding can keep H4's plain solver from its tolerance; the preconditioned
// solver gets as far as rounding allows.

#include <gtest/gtest.h>

#include <numbers>

#include "handout/check/derivative.h"
#include "particles/system.h"
#include "reference/H6/stepping_for_tests.h"
#include "solver/dense_algebra.h"

namespace reference_tests {
namespace {

using hair::GeometricTerm;
using hair::Strand;

// A soft strand of 8 segments with masses that differ, h^2 k/m about 1 for h = 1/60, and its root in motion.
Strand soft() {
  Strand strand = hair::uniform_strand({}, 8, 0.3);
  strand.mass = VectorXd::LinSpaced(9, 4e-7, 8e-7);
  strand.stretch_rigidity = strand.rest_length[0] * 6e-7 * 3600;
  return strand;
}

void set_in_motion(Hair& hair) {
  hair.place(Vector3d(0.6, 0, 0.8));
  hair.state.v = 0.3 * checks::scattered_vector(27, 7);
}

// If lengths are exact and no force acts, the constraints make the accelerations a_c that turn the
// velocities: M a_c = J' lambda, J a_c = -dJ/dt v. They are implicit like springs, which damps: a step loses
// the energy h^2 times this, a_c'M a_c / 2.
double centripetal_energy(const Strand& strand, const particles::State& state) {
  const int n = strand.segments();
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(n, 3 * n);  // columns of the particles below the root
  VectorXd turn(n), inverse_mass(3 * n);
  for (int s = 0; s < n; ++s) {
    const Vector3d w = state.v.segment<3>(3 * s + 3) - state.v.segment<3>(3 * s);
    const Vector3d d = state.x.segment<3>(3 * s + 3) - state.x.segment<3>(3 * s), u = d.normalized();
    J.block<1, 3>(s, 3 * s) = u.transpose();
    if (s > 0) J.block<1, 3>(s, 3 * s - 3) = -u.transpose();
    turn[s] = (w - u * u.dot(w)).squaredNorm() / d.norm();
    inverse_mass.segment<3>(3 * s).setConstant(1 / strand.mass[s + 1]);
  }
  const Eigen::MatrixXd between = J * inverse_mass.asDiagonal() * J.transpose();
  return 0.5 * turn.dot(solver::dense_solve(between, turn).col(0));
}

TEST(PredictorCorrector, LosesTheEnergyOfTheTurn) {
  Strand strand = soft();
  strand.stretch_rigidity *= 1e10;
  // The relative difference of a step's loss from this energy. It is of second order.
  const auto off = [&](double h) {
    Hair hair(strand, GeometricTerm::dropped, 0);
    set_in_motion(hair);
    hair.state.v.head<3>().setZero();
    hair.corrected_step(1e-9);  // makes the velocities keep the lengths
    const double before = particles::kinetic_energy(hair.particles, hair.state.v);
    const double expected = h * h * centripetal_energy(strand, hair.state);
    hair.corrected_step(h);
    return std::abs((before - particles::kinetic_energy(hair.particles, hair.state.v)) / expected - 1);
  };
  EXPECT_LT(off(1e-3), 0.02);
  EXPECT_LT(off(2.5e-4), off(1e-3) / 12) << "a sixteenth";
}

// The part of its angular momentum that a mass on a rigid rod keeps in one revolution of 80 steps. With an
// infinitely hard spring at its rest length a filter only removes the velocity along the spring. The
// correction moves the mass along the new rod, as H5 does, or along the rod at x^n.
double left_after_a_revolution(bool along_new, bool with_impulse) {
  using Eigen::Vector2d;
  constexpr int kSteps = 80;
  const double h = 2 * std::numbers::pi / kSteps;
  const auto filter = [](const Vector2d& u, const Vector2d& v) -> Vector2d { return v - u * u.dot(v); };
  Vector2d x(1, 0), v(0, 1);
  for (int step = 0; step < kSteps; ++step) {
    const Vector2d half = filter(x, v), predicted = x + h * half;
    if (along_new) {
      x = predicted.normalized();
    } else {  // |predicted - s x| = 1
      const double b = predicted.dot(x);
      x = predicted - (b - std::sqrt(b * b - predicted.squaredNorm() + 1)) * x;
    }
    const Vector2d impulse = with_impulse ? Vector2d((x - predicted) / h) : Vector2d::Zero();
    v = filter(x, half + impulse);
  }
  return x.x() * v.y() - x.y() * v.x();
}

// The table in the assignment's text, "Why the impulse".
TEST(PredictorCorrector, KeepsAngularMomentumIfItCorrectsAlongTheOldRod) {
  EXPECT_NEAR(left_after_a_revolution(true, false), 0.8183, 5e-5);
  EXPECT_NEAR(left_after_a_revolution(true, true), left_after_a_revolution(true, false), 80 * 8 * kUnit);
  EXPECT_NEAR(left_after_a_revolution(false, false), 0.8176, 5e-5);
  EXPECT_NEAR(left_after_a_revolution(false, true), 1, 80 * 8 * kUnit);
}

// If the tolerance is below rounding, ConjGrad uses up its steps and may return anything.
TEST(UnmetTolerance, HairStaysPut) {
  Strand strand = human_hair();
  strand.stretch_rigidity *= 1e6;
  Hair hair(strand, GeometricTerm::dropped);
  hair.force.hide_band();
  hair.place(Vector3d::UnitX());
  int not_met = 0;
  for (int i = 0; i < 10; ++i) {
    const particles::SolveReport report = hair.implicit_step(1.0 / 60);
    not_met += !report.converged;
    EXPECT_LE(report.residual, 1e-6 * report.rhs);
    EXPECT_LE(hair.state.v.cwiseAbs().maxCoeff(), 10) << "m/s, step " << i;
  }
  EXPECT_GT(not_met, 0) << "nothing is shown";
}

// Here rounding leaves 1e-5 to 1e-4 of the right-hand side, too much for hair: at 1e-4 it would lose gravity.
TEST(UnmetTolerance, NothingAbove1eMinus6IsTried) {
  Strand strand = human_hair();
  strand.stretch_rigidity *= 1e11;
  Hair hair(strand, GeometricTerm::dropped);
  hair.force.hide_band();
  hair.place(Vector3d::UnitX());
  hair.implicit_step(1.0 / 60);
  const particles::State before = hair.state;
  const int most = 20 * 93;  // the limit of ConjGrad's steps in a call
  const auto steps = [&](double tolerance) {
    hair.state = before;
    const particles::SolveReport report = hair.implicit_step(1.0 / 60, tolerance);
    EXPECT_FALSE(report.converged) << tolerance;
    return report.steps;
  };
  EXPECT_EQ(steps(1e-10), 3 * most) << "at 1e-10, 1e-8 and 1e-6";
  EXPECT_EQ(steps(3e-10), 3 * most) << "at 3e-10, 3e-8 and 1e-6";
  EXPECT_EQ(steps(1e-7), 2 * most) << "at 1e-7 and 1e-6";
  EXPECT_EQ(steps(1e-6), most);
}

// At 1/60 s H6's first solve misses 1e-10 in half of the steps. That does no harm: 1e-8 is enough for the
// lengths and the second solve.
TEST(UnmetTolerance, CorrectedStepsOfHumanHairComeCloseToIt) {
  const Strand strand = human_hair();
  for (double h : {1.0 / 60, 1.0 / 240, 1.0 / 960}) {
    Hair hair(strand, GeometricTerm::filtered);
    hair.force.emplace<hair::BendForce>(strand, particles::Products::definite);
    hair.force.hide_band();
    hair.place(Vector3d::UnitX());
    int not_met = 0;
    for (int i = 0; i < std::lround(1 / h); ++i) {
      const hair::StepReport report = hair.corrected_step(h);
      not_met += !report.filter.converged;
      EXPECT_LE(report.filter.residual, 1e-8 * report.filter.rhs) << "h = " << h << ", step " << i;
      EXPECT_TRUE(report.second_filter.converged && report.correction.converged)
          << "h = " << h << ", step " << i;
      EXPECT_LE(hair::largest_stretch(strand, hair.state.x), 1e-12);
    }
    if (h > 0.01)
      EXPECT_NEAR(not_met, 35, 10) << "of 60";
    else
      EXPECT_EQ(not_met, 0) << "h = " << h;
  }
}

// The preconditioned solve meets its tolerance until the masses vanish in the rounding of the springs: h^2
// k/m is 6e6 times `stiffer` here, and rounds by 2^-53 of that.
TEST(UnmetTolerance, IsOutOfTheWayWithThePreconditioner) {
  for (double stiffer : {1.0, 1e4, 1e8}) {
    Strand strand = human_hair();
    strand.stretch_rigidity *= stiffer;
    Hair hair(strand, GeometricTerm::dropped);
    hair.force.emplace<hair::BendForce>(strand, particles::Products::definite);
    hair.place(Vector3d::UnitX());
    int steps = 0;
    for (int i = 0; i < 20; ++i) {
      const hair::StepReport report = hair.corrected_step(1.0 / 60);
      EXPECT_TRUE(report.filter.converged && report.second_filter.converged) << stiffer << ", step " << i;
      steps = std::max({steps, report.filter.steps, report.second_filter.steps});
    }
    EXPECT_LE(steps, 10) << stiffer;
  }
}

}  // namespace
}  // namespace reference_tests
