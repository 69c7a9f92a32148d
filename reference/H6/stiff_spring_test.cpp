// STAFF ONLY. A mass that turns on a stiff spring, the lecture's "loss of angular momentum": the rows of the
// assignment's table that the public checks of H4 and H6 do not print.

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <numbers>

#include "reference/H6/stepping_for_tests.h"

namespace reference_tests {
namespace {

using hair::GeometricTerm;

constexpr double kTurn = 2 * std::numbers::pi, kStep = 1.0 / 60, kMass = 0.7, kLength = 0.3,
                 kStiffness = 1e8 * kMass;

hair::Strand spring() {
  hair::Strand strand;
  strand.mass = Eigen::Vector2d(kMass, kMass);
  strand.rest_length = VectorXd::Constant(1, kLength);
  strand.stretch_rigidity = kStiffness * kLength;
  return strand;
}

struct Revolution {
  double length;    // the largest |l - l0| / l0
  double radial;    // the largest velocity along the spring
  double momentum;  // L/L0
};

template <typename Step>
Revolution revolve(GeometricTerm term, Step step) {
  const hair::Strand strand = spring();
  Hair hair(strand, term, 0);
  hair.place(Vector3d::UnitX());
  hair.state.v[4] = kTurn * kLength;
  Revolution result{0, 0, 0};
  for (int i = 0; i < 60; ++i) {
    step(hair);
    result.length = std::max(result.length, largest_error(strand, hair.state.x));
    result.radial = std::max(result.radial, largest_rate(strand, hair.state.x, hair.state.v));
  }
  const Vector3d x = hair.state.x.tail<3>(), v = hair.state.v.tail<3>();
  result.momentum = x.cross(v)[2] / (kLength * kLength * kTurn);
  return result;
}

// v(t+h) = v + h f(x + h v(t+h)) / m, by Newton's method until it moves no more.
void backward_euler(Hair& hair) {
  const Vector3d x = hair.state.x.tail<3>(), before = hair.state.v.tail<3>();
  Vector3d v = before;
  for (int i = 0; i < 50; ++i) {
    const Vector3d at = x + kStep * v, u = at.normalized();
    const double l = at.norm();
    const Vector3d f = -kStiffness * (l - kLength) * u;
    const Eigen::Matrix3d K =
        kStiffness *
        (u * u.transpose() + (1 - kLength / l) * (Eigen::Matrix3d::Identity() - u * u.transpose()));
    const Vector3d residual = kMass * (v - before) - kStep * f;
    const Vector3d step =
        (kMass * Eigen::Matrix3d::Identity() + kStep * kStep * K).partialPivLu().solve(residual);
    v -= step;
    if (step.norm() < 1e-15) break;
  }
  hair.state.v.tail<3>() = v;
  hair.state.x.tail<3>() = x + kStep * v;
}

TEST(StiffSpring, ConvergedBackwardEulerLosesAThirdOfTheAngularMomentum) {
  const Revolution after = revolve(GeometricTerm::full, backward_euler);
  EXPECT_NEAR(after.momentum, 0.6583, 1e-4);
  EXPECT_NEAR(after.momentum, 1 / std::sqrt(1 + 2 * kTurn * kTurn * kStep), 2e-3) << "the limit for small h";
  EXPECT_LT(after.length, 1e-6);
}

TEST(StiffSpring, TheSecondSolveTakesTheRadialVelocityAway) {
  const Revolution after = revolve(GeometricTerm::dropped, [](Hair& hair) {
    VectorXd dv(6);
    auto scratch = hair.scratch.leftCols(particles::kImplicitScratch);
    solve_implicit(hair.force, hair.particles, hair.state, kStep / 2, kStep, 1e-10, dv, scratch);
    hair.state.v += dv;
    hair.state.x += kStep * hair.state.v;
    const VectorXd predicted = hair.state.x;
    hair::correct_lengths(hair.strand, 1e-12, 100, hair.state.x, hair.scratch);
    hair.state.v += (hair.state.x - predicted) / kStep;
  });
  EXPECT_NEAR(after.radial, 0.1, 0.1) << "without step 5";
  EXPECT_GT(after.radial, 0.05);
}

}  // namespace
}  // namespace reference_tests
