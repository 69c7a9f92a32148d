// STAFF ONLY. What solve_constraints asks of ConjGrad. The ConjGrad here takes the place of S1's: it solves nothing,
// and remembers what it was asked for.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "reference/P2/constrained_motion_for_tests.h"

namespace {

struct Asked {
  int rows = 0, most_steps = 0, times = 0;
  double epsilon = 0;
};

Asked asked;

constexpr double kLeft = 0.25;  // of the squared residual
constexpr int kTaken = 7;

}  // namespace

double ConjGrad(int n, implicitMatrix*, double x[], double[], double epsilon, int* steps) {
  asked = {n, *steps, asked.times + 1, epsilon};
  std::fill_n(x, n, 0);
  *steps = kTaken;
  return kLeft;
}

namespace reference_tests {
namespace {

ConstrainedMotion pulled_chain(int rods) {
  ConstrainedMotion chain = straight_chain(rods + 1, 0.1);
  chain.f = Eigen::VectorXd::LinSpaced(chain.f.size(), -1, 2);
  return chain;
}

// max(100, 20 rows), on both sides of where they are the same.
TEST(SolveConstraints, AllowsTwentyStepsARowAndAHundredAtLeast) {
  for (const auto& [rods, most] : {std::pair{1, 100}, {4, 100}, {5, 100}, {6, 120}, {11, 220}, {200, 4000}}) {
    asked = {};
    pulled_chain(rods).solve();
    EXPECT_EQ(asked.times, 1);
    EXPECT_EQ(asked.rows, rods);
    EXPECT_EQ(asked.most_steps, most) << rods << " rods";
  }
}

TEST(SolveConstraints, CountsTwoRowsForAWire) {
  ConstrainedMotion chain = pulled_chain(4);
  for (int i = 1; i < 4; ++i)
    chain.constraints.wires.push_back(
        {i, particles::Vector3d::Zero(), particles::Vector3d::UnitZ(), 0.1 * i});
  chain.solve();
  EXPECT_EQ(asked.rows, 10);
  EXPECT_EQ(asked.most_steps, 200);
}

// ConjGrad is told the square of the residual that will do.
TEST(SolveConstraints, AsksForATenBillionthOfTheRightHandSide) {
  ConstrainedMotion chain = pulled_chain(6);
  chain.constraints.stiffness = 10;
  chain.state.x[5] += 0.3;
  chain.solve();
  const double tolerance = 1e-10 * chain.right_hand_side().norm();
  EXPECT_GT(tolerance, 0);
  // The right-hand side is summed in another order: a few roundings of 2^-53.
  EXPECT_NEAR(std::sqrt(asked.epsilon), tolerance, 1e-12 * tolerance);
}

TEST(SolveConstraints, ReportsTheStepsTakenAndTheRootOfWhatIsReturned) {
  const particles::ConstraintReport report = pulled_chain(3).solve();
  EXPECT_EQ(report.steps, kTaken);
  EXPECT_EQ(report.residual, std::sqrt(kLeft));
}

}  // namespace
}  // namespace reference_tests
