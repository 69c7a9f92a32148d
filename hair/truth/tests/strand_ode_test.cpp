// STAFF ONLY. A strand's equations: the matrix is the derivative, and the root is at its rider's position.
#include "hair/truth/strand_ode.h"

#include <gtest/gtest.h>

#include "hair/strand/variation.h"
#include "problems.h"

namespace reference_tests {
namespace {

using hair::Problem;

TEST(StrandOde, HasTheDerivativeOfItsRates) {
  Problem problem = level_strand();
  problem.scene.hair.drag = 1e-3;
  problem.scene.hair.strands[0].strand.skip_rigidity = 0.01;
  hair::StrandOde ode(problem);
  const int n = ode.size();
  hair::Variation variation(3);
  Eigen::VectorXd y = ode.start(), up(n), down(n);
  for (double& value : y) value += variation.uniform(-2e-3, 2e-3);
  hair::BandMatrix df{Eigen::MatrixXd::Zero(ode.above() + 1 + ode.below(), n), ode.above(), ode.below()};
  ASSERT_TRUE(ode.jacobian(0, y, df));
  for (int j = 0; j < n; ++j) {
    constexpr double kStep = 1e-7;
    Eigen::VectorXd moved = y;
    moved[j] += kStep;
    ode.rates(0, moved, up);
    moved[j] -= 2 * kStep;
    ode.rates(0, moved, down);
    const Eigen::VectorXd column = (up - down) / (2 * kStep);
    // Differences of the second order: about (kStep / 1 cm)^2, and roundings 1e-16 / 1e-7 of the largest
    // entries.
    const double off = 1e-6 * column.lpNorm<Eigen::Infinity>();
    for (int i = 0; i < n; ++i) {
      const bool inside = i - j <= df.below && j - i <= df.above;
      ASSERT_NEAR(inside ? df(i, j) : 0.0, column[i], off) << "entry " << i << ", " << j;
    }
  }
}

TEST(StrandOde, ItsRootIsWhereItsRiderIs) {
  const Problem problem = carried_strand();
  const hair::Motion& motion = problem.scene.riders[0].motion;
  hair::StrandRoot root(problem.scene);
  const hair::Vector3d start = problem.scene.hair.strands[0].state.x.head<3>();
  double from = 0;
  std::vector<double> until = root.breaks();
  ASSERT_EQ(until.size(), 3U);
  until.push_back(0.1);
  for (const double to : until) {
    root.start_span(from);
    for (const double part : {0.1, 0.5, 0.8}) {
      const double t = from + part * (to - from), h = 1e-5;
      const hair::RootMotion at = root.at(t);
      const auto place = [&](double time) { return hair::way_at(motion, time)(start); };
      EXPECT_LE((at.position - place(t)).norm(), 1e-16);
      // h^2 / 6 times third derivatives of about 0.02 m * 12 / (0.034 s)^3, and for the second h^2 / 12 times
      // fourth.
      EXPECT_LE((at.velocity - (place(t + h) - place(t - h)) / (2 * h)).norm(), 1e-6) << "at " << t;
      EXPECT_LE((at.acceleration - (root.at(t + h).velocity - root.at(t - h).velocity) / (2 * h)).norm(),
                1e-3)
          << "at " << t;
      EXPECT_LE((at.tangent - hair::way_at(motion, t).rotation * hair::Vector3d::UnitX()).norm(), 1e-14);
    }
    from = to;
  }
  const hair::AccurateMotion found = motion_of(problem, 1e-8);
  for (int k = 0; k <= hair::kMoments; ++k)
    EXPECT_LE((found.states[k].x.head<3>() - hair::way_at(motion, 0.1 * k / hair::kMoments)(start)).norm(),
              1e-15);
}

// A moment's time, 12 sixteenths of the duration, may be a rounding below the key's.
TEST(StrandOde, ItsRootStopsAtAKeyThatIsAMoment) {
  for (const auto& [duration, key] : {std::pair(0.15, 0.1125), {0.3, 0.225}, {0.6, 0.45}, {0.1, 0.075}}) {
    Problem problem = level_strand();
    problem.duration = duration;
    hair::Motion motion;
    motion.keys.push_back({0, {}});
    motion.keys.push_back({key, {{0.01, 0, 0}, Eigen::Quaterniond::Identity()}});
    problem.scene.riders = {{motion, {0}, {}}};
    const hair::Trajectory states = motion_of(problem, 1e-5).states;
    EXPECT_GT(states[6].v.head<3>().norm(), 0.01 / duration) << "halfway it moves";
    for (int k = 13; k <= hair::kMoments; ++k)
      EXPECT_EQ(states[k].v.head<3>().norm(), 0) << "duration " << duration << ", moment " << k;
  }
}

}  // namespace
}  // namespace reference_tests
