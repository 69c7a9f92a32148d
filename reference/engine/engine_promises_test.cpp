// STAFF ONLY. The engine's own promises: the same bits each time, strands that do not affect each other,
// steps that allocate nothing, and hair that holds.

#include <bit>
#include <limits>

#include "hair/strand/measures.h"
#include "reference/engine/engine_states.h"
#include "solver/test_allocations.h"

namespace hair::engine {
namespace {

FullHeadSettings everything() {
  FullHeadSettings settings = bare();
  settings.bending = settings.correct_lengths = true;
  settings.head = std::make_shared<Ball>(kBall);
  settings.friction = 0.3;
  settings.grid_spacing = 1e-2;
  return settings;
}

Eigen::Isometry3d pose_at(double t) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::AngleAxisd(std::sin(6 * t), Vector3d::UnitZ()).toRotationMatrix();
  pose.translation() = Vector3d(0.05 * std::sin(9 * t), 0, 0);
  return pose;
}

void run(FullHead& head, int steps, double h = 1.0 / 120) {
  for (int i = 1; i <= steps; ++i) head.step(h, pose_at(i * h));
}

bool same_bits(const VectorXd& a, const VectorXd& b) {
  for (Eigen::Index i = 0; i < a.size(); ++i)
    if (std::bit_cast<std::uint64_t>(a[i]) != std::bit_cast<std::uint64_t>(b[i])) return false;
  return true;
}

// Enough strands for both threads to be at work at once.
TEST_P(Engine, GivesTheSameBitsWithOneThreadAndTwo) {
  std::vector<int> points;
  std::vector<Start> all;
  for (int k = 0; k < 2000; ++k) {
    points.push_back(kPoints[k % kPoints.size()]);
    all.push_back(some_start(points.back(), k));
  }
  FullHeadSettings settings = everything();
  FullHead one(points, settings);
  settings.threads = 2;
  FullHead two(points, settings);
  set(one, all);
  set(two, all);
  run(one, 10);
  run(two, 10);
  for (int k = 0; k < one.strands(); ++k) {
    EXPECT_TRUE(same_bits(state(one, k).x, state(two, k).x)) << "strand " << k;
    EXPECT_TRUE(same_bits(state(one, k).v, state(two, k).v)) << "strand " << k;
  }
}

// Compares a strand alone with the same strand among others, one of which is NaN.
TEST_P(Engine, KeepsNansInTheirStrandAndSaysWhich) {
  constexpr int kLost = 4;
  FullHead head(kPoints, everything());
  auto all = starts();
  all[kLost].x[20] = std::numeric_limits<double>::quiet_NaN();
  all[8].v[500] = std::numeric_limits<double>::infinity();
  set(head, all);
  run(head, 20);
  EXPECT_EQ(head.broken(), 2);
  EXPECT_EQ(head.broke_at(kLost), 1);
  EXPECT_EQ(head.broke_at(8), 1);
  for (int k = 0; k < head.strands(); ++k) {
    if (k == kLost || k == 8) continue;
    FullHead alone(std::vector<int>{kPoints[k]}, everything());
    alone.set_strand(0, all[k].rest_length, all[k].tangent, all[k].x, all[k].v);
    run(alone, 20);
    particles::State expected{VectorXd(3 * kPoints[k]), VectorXd(3 * kPoints[k])};
    alone.get_strand(0, expected.x, expected.v);
    EXPECT_TRUE(same_bits(state(head, k).x, expected.x)) << "strand " << k;
  }
}

TEST_P(Engine, HoldsStiffHairOnAHeadThatShakes) {
  FullHeadSettings settings = everything();
  for (const double times : {1.0, 1e4})
    for (const double h : {1.0 / 960, 1.0 / 24}) {
      settings.material.young_modulus = 3e9 * times;
      FullHead head(kPoints, settings);
      set(head, starts());
      run(head, 48, h);
      EXPECT_EQ(head.broken(), 0);
      for (int k = 0; k < head.strands(); ++k)
        EXPECT_LE(state(head, k).v.cwiseAbs().maxCoeff(), 30) << times << ", h " << h << ", strand " << k;
    }
}

// Roots are flung to and fro at 100 m/s. Once lengths are right, each point is within L of its root, so it
// moves relative to the root by at most 2 L in a step.
TEST_P(Engine, HoldsStiffHairThatIsFlung) {
  constexpr double kFlung = 100;
  FullHeadSettings settings = bare();
  settings.bending = settings.correct_lengths = true;
  for (const double times : {1.0, 1e2, 1e4})
    for (const double h : {1.0 / 960, 1.0 / 240, 1.0 / 60, 1.0 / 24}) {
      settings.material.young_modulus = 3e9 * times;
      FullHead head(kPoints, settings);
      const auto all = starts();
      set(head, all);
      Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
      for (int i = 0; i < 12; ++i) {
        pose.translation().x() += kFlung * h * (i % 4 < 2 ? 1 : -1);
        head.step(h, pose);
      }
      EXPECT_EQ(head.broken(), 0) << times << ", h " << h;
      for (int k = 0; k < head.strands(); ++k) {
        const particles::State after = state(head, k);
        const double length = all[k].rest_length * (kPoints[k] - 1);
        const auto moving = given_strand(settings, kPoints[k], all[k].rest_length, all[k].tangent);
        EXPECT_LE(largest_stretch(moving->strand, after.x), 1e-11)
            << times << ", h " << h << ", strand " << k;
        for (int i = 0; i < kPoints[k]; ++i)
          EXPECT_LE(after.v.segment<3>(3 * i).norm(), 1.001 * (kFlung + 2 * length / h))
              << times << ", h " << h << ", strand " << k << ", point " << i;
      }
    }
}

TEST_P(Engine, AllocatesNothingInAStep) {
  FullHeadSettings settings = everything();
  settings.threads = 2;
  FullHead head(kPoints, settings);
  set(head, starts());
  const long before = reference_tests::allocations();
  run(head, 3);
  EXPECT_EQ(reference_tests::allocations(), before);
}

TEST_P(Engine, RefusesWhatItCannotDo) {
  FullHead head(kPoints, {});
  EXPECT_THROW(head.step(0.01), std::invalid_argument);
  EXPECT_THROW(FullHead(std::vector<int>{1}, {}), std::invalid_argument);
  const Start start = some_start(25, 1);
  EXPECT_THROW(head.set_strand(1, 0.01, start.tangent, start.x, start.v), std::invalid_argument);
  EXPECT_THROW(head.set_strand(0, 0, start.tangent, start.x, start.v), std::invalid_argument);
  EXPECT_THROW(head.set_strand(0, 0.01, 2 * start.tangent, start.x, start.v), std::invalid_argument);
}

}  // namespace
}  // namespace hair::engine
