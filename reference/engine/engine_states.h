// STAFF ONLY. For the engine's tests: strands in all kinds of states, and a test for each instruction set.
#pragma once

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cmath>
#include <vector>

#include "hair/strand/variation.h"
#include "reference/engine/head_of_strands.h"

namespace hair::engine {

using Eigen::VectorXd;

// AVX-512 and all better targets of Highway, which have smaller numbers.
inline constexpr long long kAvx512 = 2 * HWY_AVX3 - 1;

struct InstructionSet {
  const char* name;
  long long disabled;  // Highway's targets that are switched off
};

// Each test runs with each of the kernels that this processor can run.
class Engine : public testing::TestWithParam<InstructionSet> {
 public:
  void SetUp() override { use(GetParam().disabled); }
  void TearDown() override { use(0); }

 private:
  static void use(long long disabled) {
    hwy::DisableTargets(disabled);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
};

class Ball : public Solid {
 public:
  explicit Ball(double radius, const Vector3d& centre = Vector3d::Zero())
      : radius_(radius), centre_(centre) {}
  Surface surface_at(const Vector3d& point) const override {
    const Vector3d from = point - centre_;
    const double distance = from.norm();
    return {distance - radius_, distance > 0 ? Vector3d(from / distance) : Vector3d::UnitZ()};
  }
  Eigen::AlignedBox3d box() const override {
    return {centre_ - Vector3d::Constant(radius_), centre_ + Vector3d::Constant(radius_)};
  }

 private:
  double radius_;
  Vector3d centre_;
};

// A head turned about an axis that is not special to any rotation matrix.
inline Eigen::Isometry3d turned_head(double angle, const Vector3d& at = Vector3d::Zero()) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::AngleAxisd(angle, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  pose.translation() = at;
  return pose;
}

inline Vector3d some_direction(Variation& random) {
  for (;;) {
    const Vector3d d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    if (d.norm() > 0.1 && d.norm() < 1) return d.normalized();
  }
}

// A strand on a ball, bent at random and moving.
struct Start {
  double rest_length;
  Vector3d tangent;
  VectorXd x, v;
};

inline constexpr double kBall = 0.1;

inline Start some_start(int points, std::uint64_t seed, double bend = 0.4, double speed = 1) {
  Variation random(seed, points);
  Start start;
  start.rest_length = random.uniform(0.006, 0.012);
  start.tangent = some_direction(random);
  start.x.resize(3 * points);
  start.v.resize(3 * points);
  start.x.head<3>() = kBall * start.tangent;
  start.v.head<3>().setZero();
  Vector3d along = start.tangent;
  for (int i = 1; i < points; ++i) {
    along = (along + bend * some_direction(random)).normalized();
    start.x.segment<3>(3 * i) =
        start.x.segment<3>(3 * i - 3) + start.rest_length * (1 + random.uniform(-1e-4, 1e-4)) * along;
    start.v.segment<3>(3 * i) = speed * some_direction(random);
  }
  return start;
}

// Numbers of points, of which some fill a group and others do not; the least and a large one are among them.
inline const std::vector<int> kPoints = {25, 2, 25, 3, 25, 4, 25, 25, 200, 25, 25, 25, 25, 5, 25, 3, 25};

inline std::vector<Start> starts(double bend = 0.4, double speed = 1) {
  std::vector<Start> all;
  for (std::size_t k = 0; k < kPoints.size(); ++k) all.push_back(some_start(kPoints[k], k, bend, speed));
  return all;
}

inline void set(FullHead& head, const std::vector<Start>& all) {
  for (std::size_t k = 0; k < all.size(); ++k)
    head.set_strand(static_cast<int>(k), all[k].rest_length, all[k].tangent, all[k].x, all[k].v);
}

inline particles::State state(const FullHead& head, int k) {
  const int size = 3 * kPoints[k % kPoints.size()];
  particles::State s{VectorXd(size), VectorXd(size)};
  head.get_strand(k, s.x, s.v);
  return s;
}

inline std::vector<particles::State> after(const FullHeadSettings& settings, const std::vector<Start>& all,
                                           double h,
                                           const Eigen::Isometry3d& pose = Eigen::Isometry3d::Identity()) {
  FullHead head(kPoints, settings);
  set(head, all);
  head.step(h, pose);
  std::vector<particles::State> states;
  for (int k = 0; k < head.strands(); ++k) states.push_back(state(head, k));
  EXPECT_EQ(head.broken(), 0);
  return states;
}

// The largest residual of H4's equation that rounding explains, N s: see expect_solved.
inline double residual_bound(double matrix_norm, double rhs_norm, const particles::State& before,
                             const particles::State& after, double h) {
  const double speeds = (after.v - before.v).norm() + before.v.norm() +
                        after.x.cwiseAbs().maxCoeff() / h * std::sqrt(static_cast<double>(after.x.size()));
  return 150 * 0x1p-53 * (matrix_norm * speeds + rhs_norm);
}

inline FullHeadSettings bare() {
  FullHeadSettings settings;
  settings.drag = 2;
  settings.wind = {3, -1, 0.5};
  settings.bending = settings.correct_lengths = false;
  return settings;
}

}  // namespace hair::engine
