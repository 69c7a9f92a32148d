// STAFF ONLY. A strand's equations: the matrix is the derivative, and the root is at its rider's position. A
// strand that is too stiff to stretch moves like one that does not stretch.

#include <gtest/gtest.h>

#include <cmath>

#include "hair/strand/make_strand.h"
#include "hair/strand/variation.h"
#include "hair/truth/rigid_strand_ode.h"
#include "hair/truth/strand_ode.h"
#include "hair/truth/test_problems.h"

namespace reference_tests {
namespace {

using hair::Problem;

using hair::AccurateMotion;

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

TEST(RigidStrand, KeepsItsLengths) {
  for (const Problem& problem : {level_strand(1e6), carried_strand(1e6)}) {
    const AccurateMotion motion = motion_of(problem);
    ASSERT_TRUE(motion.inextensible);
    const hair::Strand& strand = problem.scene.hair.strands[0].strand;
    for (const particles::State& state : motion.states) {
      for (int i = 0; i < strand.segments(); ++i) {
        const hair::Vector3d e = state.x.segment<3>(3 * i + 3) - state.x.segment<3>(3 * i);
        const hair::Vector3d de = state.v.segment<3>(3 * i + 3) - state.v.segment<3>(3 * i);
        EXPECT_NEAR(e.norm() / strand.rest_length[i], 1, 1e-14);
        EXPECT_NEAR(e.normalized().dot(de), 0, 1e-14 * (1 + state.v.norm()));
      }
    }
    EXPECT_GT((motion.states.back().x - motion.states.front().x).norm(), 0.01) << "it did move";
    EXPECT_LE(motion.agreement, hair::kLeastError);
  }
}

// To first order in 1/EA, the distance from the limit is the stretch by tensions: ten times the EA, a
// tenth of it. And the agreement of a rigid strand's motion covers this distance.
TEST(RigidStrand, IsTheLimitOfThoseThatStretchAndSaysHowFarItIs) {
  constexpr double kSoft = 0.003, kHard = 0.03, kHardest = 101;
  for (Problem (*make)(double) : {level_strand, carried_strand}) {
    const AccurateMotion limit = motion_of(make(kHardest));
    ASSERT_TRUE(limit.inextensible);
    const double soft = hair::largest_distance(motion_of(make(kSoft), 1e-10).states, limit.states);
    const double hard = hair::largest_distance(motion_of(make(kHard), 1e-10).states, limit.states);
    EXPECT_NEAR(hard / soft, kSoft / kHard, 0.02) << soft << " m, then " << hard << " m";
    const double hardest = hard * kHard / kHardest;
    EXPECT_LE(hardest, limit.agreement);
    EXPECT_GE(hardest, limit.agreement / 20) << "else it says too much";
  }
}

TEST(RigidStrand, HairIsAsHardAsHairWhateverItsRadius) {
  for (const double radius : {20e-6, 50e-6, 1e-3}) {
    hair::Material material;
    material.radius = radius;
    EXPECT_NEAR(hair::times_the_ea_of_hair(hair::uniform_strand(material, 7, 0.1)), 1, 1e-12);
    material.young_modulus *= 1000;
    EXPECT_NEAR(hair::times_the_ea_of_hair(hair::uniform_strand(material, 7, 0.1)), 1000, 1e-9);
  }
}

TEST(RigidStrand, IsNoLimitOfOneThatStartsStretched) {
  Problem problem = level_strand(1e6);
  EXPECT_TRUE(hair::starts_rigid(problem));
  problem.scene.hair.strands[0].state.x[3] += 1e-6;
  EXPECT_FALSE(hair::starts_rigid(problem));
  problem = level_strand(1e6);
  problem.scene.hair.strands[0].state.v[3] = 1e-3;
  EXPECT_FALSE(hair::starts_rigid(problem));
  problem = level_strand(1e6);
  problem.scene.hair.strands[0].state.v[5] = 1;  // across
  EXPECT_TRUE(hair::starts_rigid(problem));
}

}  // namespace
}  // namespace reference_tests
