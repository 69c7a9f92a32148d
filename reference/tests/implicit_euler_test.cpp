// STAFF ONLY. What particles/implicit_euler.h promises, sentence by sentence.

#include "particles/implicit_euler.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "particles/springs.h"
#include "reference/tests/stepping.h"
#include "solver/tests/allocations.h"

namespace reference_tests {
namespace {

using particles::Input;
using particles::Output;
using particles::Particles;
using particles::SolveReport;
using particles::State;

// f = -K x - D v, and counts.
class Linear : public particles::Force {
 public:
  explicit Linear(int n) : K(3 * n, 3 * n), D(3 * n, 3 * n) {
    const MatrixXd R = scattered_vector(K.size(), n).reshaped(3 * n, 3 * n);
    const MatrixXd S = scattered_vector(D.size(), n + 50).reshaped(3 * n, 3 * n);
    K = R * R.transpose();
    D = S * S.transpose();
  }
  double energy(Input x) const override { return 0.5 * x.dot(K * x); }
  void add_force(Input x, Input v, Output f) const override {
    ++forces;
    f.noalias() -= K * x;
    f.noalias() -= D * v;
  }
  void add_dfdx(Input, Input, Input dx, Output df) const override {
    ++dfdx;
    df.noalias() -= K * dx;
  }
  void add_dfdv(Input, Input, Input dv, Output df) const override {
    ++dfdv;
    df.noalias() -= D * dv;
  }

  MatrixXd K, D;
  mutable int forces = 0, dfdx = 0, dfdv = 0;
};

struct Case {
  explicit Case(int n) : force(n), particles{VectorXd::LinSpaced(n, 2, 5), std::vector<char>(n, 0)} {
    state = {scattered_vector(3 * n, 3), scattered_vector(3 * n, 4)};
    scratch.setConstant(3 * n, particles::kImplicitScratch, kNaN);
  }
  Linear force;
  Particles particles;
  State state;
  MatrixXd scratch;
};

// The table by its definition.
MatrixXd expected_table(const Case& c, double a, double b) {
  const int n = c.particles.count();
  MatrixXd A = a * c.force.D + a * b * c.force.K;
  for (int i = 0; i < 3 * n; ++i) A(i, i) += c.particles.mass[i / 3];
  for (int i = 0; i < n; ++i) {
    if (!c.particles.is_pinned(i)) continue;
    A.middleRows<3>(3 * i).setZero();
    A.middleCols<3>(3 * i).setZero();
    A.block<3, 3>(3 * i, 3 * i).setIdentity();
  }
  return A;
}

TEST(ImplicitMatrix, IsMassesMinusBothDerivatives) {
  for (int n : {1, 2, 7}) {
    Case c(n);
    for (int pinned = -1; pinned < n; ++pinned) {
      c.particles.pinned.assign(n, 0);
      if (pinned >= 0) c.particles.pinned[pinned] = 1;
      const MatrixXd A = table(*implicit_matrix(c.force, c.particles, c.state, 0.3, 0.7), c.state.x.size());
      const MatrixXd expected = expected_table(c, 0.3, 0.7);
      EXPECT_LE((A - expected).norm(), (3 * n + 8) * kUnit * expected.norm()) << "rounding of 3n terms";
      EXPECT_LE((A - A.transpose()).norm(), 2 * (3 * n + 8) * kUnit * expected.norm());
    }
  }
}

TEST(ImplicitMatrix, TakesOneProductOfEachKindAndAllocatesNothing) {
  Case c(4);
  auto matrix = implicit_matrix(c.force, c.particles, c.state, 0.3, 0.7);
  EXPECT_EQ(c.force.dfdx + c.force.dfdv, 0);
  VectorXd x = scattered_vector(12, 1), b(12);
  const long before = allocations();
  ASSERT_GT(before, 0) << "nothing is counted";
  matrix->matVecMult(x.data(), b.data());
  EXPECT_EQ(allocations(), before);
  EXPECT_EQ(c.force.dfdx, 1);
  EXPECT_EQ(c.force.dfdv, 1);
  EXPECT_EQ(x, scattered_vector(12, 1)) << "the input is left alone";
}

TEST(SolveImplicit, MeetsItsTolerance) {
  for (int n : {1, 3, 8})
    for (double tolerance : {1e-2, 1e-6, 1e-10}) {
      Case c(n);
      c.particles.pinned[n / 2] = n > 1;
      VectorXd dv = VectorXd::Constant(3 * n, kNaN);
      const SolveReport report =
          solve_implicit(c.force, c.particles, c.state, 0.3, 0.7, tolerance, dv, c.scratch);
      const VectorXd rhs = right_hand_side(c.force, c.particles, c.state, 0.3, 0.7);
      const MatrixXd A = expected_table(c, 0.3, 0.7);
      const double drift = 64 * (10 + 4 * (3 * n + 8)) * kUnit * A.norm() * (2 * dv.norm() + rhs.norm());
      EXPECT_LE((rhs - A * dv).norm(), tolerance * rhs.norm() + drift) << "drift: solver/linearSolver.h";
      EXPECT_TRUE(report.converged);
      EXPECT_NEAR(report.residual, (rhs - A * dv).norm(), drift);
      EXPECT_NEAR(report.rhs, rhs.norm(), 1e-13 * rhs.norm());
      EXPECT_LE(report.residual, tolerance * report.rhs);
      if (n > 1) {
        EXPECT_EQ(dv.segment<3>(3 * (n / 2)), Vector3d::Zero()) << "pinned";
      }
    }
}

TEST(SolveImplicit, CountsWhatItTakes) {
  Case c(6);
  VectorXd dv(18);
  const SolveReport report = solve_implicit(c.force, c.particles, c.state, 0.3, 0.7, 1e-10, dv, c.scratch);
  EXPECT_EQ(c.force.forces, 1);
  EXPECT_EQ(c.force.dfdv, 1 + report.steps + report.steps / 64);
  EXPECT_EQ(c.force.dfdx, c.force.dfdv + 1) << "and one for the right-hand side";
}

TEST(SolveImplicit, SaysWhereItsMatrixIsNotPositiveDefinite) {
  // A spring at half of its length, h^2 k/m = 1e4: across it the geometric term is -k.
  const particles::DampedSprings spring({{0, 1, 1e6, 1.0}});
  const Particles particles{Eigen::Vector2d(1, 1), {1, 0}};
  State state{VectorXd::Zero(6), VectorXd::Zero(6)};
  state.x[3] = 0.5;
  state.v << 0, 0, 0, 0.1, 0.2, 0.3;
  VectorXd dv(6);
  MatrixXd scratch(6, particles::kImplicitScratch);
  const SolveReport exact = solve_implicit(spring, particles, state, 0.1, 0.1, 1e-10, dv, scratch);
  EXPECT_FALSE(exact.converged);
  EXPECT_TRUE(dv.allFinite());
  const particles::DampedSprings filtered({{0, 1, 1e6, 1.0}}, particles::Products::definite);
  EXPECT_TRUE(solve_implicit(filtered, particles, state, 0.1, 0.1, 1e-10, dv, scratch).converged);
}

TEST(SolveImplicit, SaysWhereNumbersAreNotFinite) {
  Case c(2);
  c.state.x[1] = kNaN;
  VectorXd dv(6);
  EXPECT_FALSE(solve_implicit(c.force, c.particles, c.state, 0.3, 0.3, 1e-10, dv, c.scratch).converged);
}

TEST(ImplicitEuler, MovesWithTheNewVelocity) {
  Case c(3);
  c.particles.pinned[0] = 1;
  const State before = c.state;
  VectorXd dv(9);
  solve_implicit(c.force, c.particles, c.state, 0.2, 0.2, 1e-10, dv, c.scratch);
  c.force.forces = 0;
  implicit_euler(c.force, c.particles, 0.2, 1e-10, c.state, c.scratch);
  EXPECT_EQ(c.force.forces, 1);
  EXPECT_EQ(c.state.v, before.v + dv);
  EXPECT_EQ(c.state.x, before.x + 0.2 * c.state.v);
  EXPECT_EQ(c.state.v.head<3>(), before.v.head<3>()) << "pinned";
}

TEST(ImplicitEuler, AllocatesNothingBeyondConjGrad) {
  Case c(5);
  const auto step = [&] { implicit_euler(c.force, c.particles, 0.2, 1e-10, c.state, c.scratch); };
  step();
  long before = allocations();
  step();
  EXPECT_EQ(allocations() - before, 3) << "ConjGrad's three vectors";
}

TEST(ImplicitEuler, DampsAnOscillatorAsBackwardEulerDoes) {
  for (double hw : {0.1, 1.0, 10.0, 1000.0}) {
    const double h = 0.01, w = hw / h;
    const particles::DampedSprings spring({{0, 1, 3 * w * w, 1.0}});
    const Particles particles{Eigen::Vector2d(3, 3), {1, 0}};
    State state{VectorXd::Zero(6), VectorXd::Zero(6)};
    state.x[3] = 1.1;
    MatrixXd scratch(6, particles::kImplicitScratch);
    double amplitude = 0.1;
    for (int i = 0; i < 3; ++i) {
      const double before = state.v[3];
      implicit_euler(spring, particles, h, 1e-10, state, scratch);
      const double now = std::hypot(state.x[3] - 1, state.v[3] / w);
      // dv is solved for to 1e-10, and rounds by 2^-53 of ConjGrad's first guess, the right-hand side; x, about 1 m,
      // rounds by 2^-53.
      const double dv = std::abs(state.v[3] - before), guess = 3 * (1 + hw * hw) * dv;
      const double error = (1e-10 * dv + 2 * kUnit * guess) * std::max(h, 1 / w) + 4 * kUnit;
      EXPECT_NEAR(now / amplitude, 1 / std::sqrt(1 + hw * hw), error / amplitude)
          << "h w = " << hw << ", step " << i;
      amplitude = now;
      if (amplitude < 1e-9) break;
    }
  }
}

}  // namespace
}  // namespace reference_tests
