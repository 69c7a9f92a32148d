// STAFF ONLY. The engine's head against given code's obstacles.h, alone and after all else that a step does.

#include <algorithm>
#include <cmath>
#include <memory>

#include "hair/length_correction.h"
#include "hair/obstacles/obstacles.h"
#include "hair/predictor_corrector.h"
#include "hair/strand/measures.h"
#include "particles/implicit_euler.h"
#include "reference/engine/distance_grid.h"
#include "reference/engine/engine_states.h"

namespace hair::engine {
namespace {

// Integers are right to half a unit; the single precision before them adds little. The largest distance is at
// a corner.
TEST(DistanceGrid, KeepsDistancesToHalfAUnit) {
  constexpr double kSpacing = 0.01;
  const Ball ball(kBall);
  const DistanceGrid grid(ball, kSpacing);
  const GridView view = grid.view();
  const double largest = std::sqrt(3) * (kBall + 4 * kSpacing);
  EXPECT_LE(view.unit, largest / 32767);
  for (int k = 0; k < view.count[2]; ++k)
    for (int j = 0; j < view.count[1]; ++j)
      for (int i = 0; i < view.count[0]; ++i) {
        const Vector3d point = Vector3d(view.low[0], view.low[1], view.low[2]) + kSpacing * Vector3d(i, j, k);
        const double kept = view.unit * view.distance[(k * view.count[1] + j) * view.count[0] + i];
        ASSERT_NEAR(kept, ball.surface_at(point).distance, 0.5 * view.unit + 0x1p-24 * largest)
            << i << " " << j << " " << k;
      }
}

// A ball beside the axis that the head turns about, so that a head turned wrongly is elsewhere.
std::shared_ptr<const Solid> ball_beside_the_axis(double radius) {
  return std::make_shared<Ball>(radius, Vector3d(0.02, -0.01, 0.015));
}

// Given code's collision in the head's axes, in which the head is at rest. Before the step they are the
// world's axes.
CollisionReport collide_in_the_heads_axes(const FullHeadSettings& settings, const MovingStrand& moving,
                                          const Eigen::Isometry3d& pose, double h, const VectorXd& x_before,
                                          particles::State& state) {
  const std::vector<Obstacle> obstacles = {
      {PlacedSolid{std::make_shared<DistanceGrid>(*settings.head, settings.grid_spacing)},
       settings.friction}};
  particles::State seen = state;
  for (Eigen::Index i = 0; i < seen.x.size(); i += 3)
    seen.x.segment<3>(i) = pose.inverse() * Vector3d(state.x.segment<3>(i));
  seen.v = (seen.x - x_before) / h;
  const VectorXd v = seen.v;
  const CollisionReport report = collide(obstacles, moving.particles, h, x_before, seen);
  for (Eigen::Index i = 0; i < seen.x.size(); i += 3) {
    state.x.segment<3>(i) = pose * Vector3d(seen.x.segment<3>(i));
    state.v.segment<3>(i) += pose.linear() * (seen.v - v).segment<3>(i);
  }
  return report;
}

TEST_P(Engine, PushesHairOutOfATurnedHeadAsGivenCodeDoes) {
  constexpr double h = 1.0 / 240;
  FullHeadSettings settings = bare();
  const auto all = starts(0.8, 2);
  const Eigen::Isometry3d pose = turned_head(0.1, h * Vector3d(0.5, 0.2, -0.1));
  const auto free = after(settings, all, h, pose);
  settings.head = ball_beside_the_axis(0.09);
  for (const double friction : {0.0, 0.3}) {
    settings.friction = friction;
    const auto states = after(settings, all, h, pose);
    const std::vector<Obstacle> obstacles = {
        {PlacedSolid{std::make_shared<DistanceGrid>(*settings.head, settings.grid_spacing),
                     pose.translation(), Eigen::Quaterniond(pose.linear())}}};
    int contacts = 0;
    for (std::size_t k = 0; k < all.size(); ++k) {
      const auto moving = given_strand(settings, kPoints[k], all[k].rest_length, all[k].tangent);
      particles::State expected = free[k], placed = free[k];
      contacts += collide_in_the_heads_axes(settings, *moving, pose, h, all[k].x, expected).contacts;
      EXPECT_LE((states[k].x - expected.x).cwiseAbs().maxCoeff(), 3 * kContactDepth)
          << "strand " << k << ", friction " << friction;
      EXPECT_LE((states[k].v - expected.v).cwiseAbs().maxCoeff(), 1e-3)
          << "strand " << k << ", friction " << friction;
      for (int i = 1; i < kPoints[k]; ++i)
        EXPECT_GE(surface_at(obstacles[0], states[k].x.segment<3>(3 * i)).distance, -1.01 * kContactDepth);
      if (friction > 0) continue;
      // Without friction places do not depend on how the head moves.
      collide(obstacles, moving->particles, h, all[k].x, placed);
      EXPECT_LE((states[k].x - placed.x).cwiseAbs().maxCoeff(), 3 * kContactDepth) << "strand " << k;
    }
    EXPECT_GT(contacts, 10);
  }
}

// Compares a whole step, with bending, with given code's. The bound on their distance has four parts:
//
//   - The matrix A is at least M, since springs and drag add nothing negative: a residual r is an error of at
//     most |r| / m in v and h |r| / m in x, with the least mass m. ConjGrad reports its residual; rounding
//     bounds the engine's.
//   - The correction projects in the metric of masses, which are m to 2 m: in our metric an error grows at
//     most by sqrt 2. It also turns the segments' directions by 2 error / l0. These directions carry at most
//     all corrected lengths together, n s l0 with the largest stretch s: 2 n s times the error more.
//   - Pushing out of a ball from less than half of its radius, and friction, each at most double an error.
//   - A push ends as in the tests above.
//
// Points that touch only because of an error are left out, since they may have either velocity.
TEST_P(Engine, DoesAllOfAStepAsGivenCodeDoes) {
  constexpr double h = 1.0 / 240;
  FullHeadSettings settings = bare();
  settings.bending = settings.correct_lengths = true;
  settings.head = ball_beside_the_axis(0.115);
  settings.friction = 0.3;
  const auto all = starts(0.2, 0.5);
  const Eigen::Isometry3d pose = turned_head(0.02, h * Vector3d(0.5, 0.2, -0.1));
  const auto states = after(settings, all, h, pose);
  const DistanceGrid grid(*settings.head, settings.grid_spacing);
  int contacts = 0, left_out = 0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const double n = kPoints[k];
    const auto moving =
        given_strand(settings, kPoints[k], all[k].rest_length, pose.linear() * all[k].tangent);
    particles::State before{all[k].x, all[k].v};
    const Vector3d root = before.x.head<3>();
    before.v.head<3>() = (pose * root - root) / h;
    particles::State expected = before;
    Eigen::MatrixXd scratch(before.x.size(), std::max(particles::kImplicitScratch, kCorrectionScratch));
    const particles::Preconditioner band(moving->force, moving->particles, before, h, h, scratch);
    const double norm = band.norm();
    const auto solved =
        implicit_euler(moving->force, moving->particles, h, particles::kSolveTolerance, expected, scratch);
    ASSERT_TRUE(solved.converged);
    const double residual = solved.residual + residual_bound(norm, solved.rhs, before, expected, h);
    const double stretch = largest_stretch(moving->strand, expected.x);

    const VectorXd uncorrected = expected.x;
    ASSERT_TRUE(
        correct_lengths(moving->strand, kLengthTolerance, kMostCorrections, expected.x, scratch).converged);
    expected.v += (expected.x - uncorrected) / h;
    const particles::State free = expected;
    contacts += collide_in_the_heads_axes(settings, *moving, pose, h, all[k].x, expected).contacts;

    const double solve_error = h * residual / moving->strand.mass.minCoeff();
    const double error = 4 * std::sqrt(2) * (1 + 2 * n * stretch) * solve_error;
    for (int i = 1; i < kPoints[k]; ++i) {
      const auto at = [&](const VectorXd& numbers) { return numbers.segment<3>(3 * i); };
      EXPECT_LE((at(states[k].x) - at(expected.x)).cwiseAbs().maxCoeff(), error + 3 * kContactDepth)
          << "strand " << k << ", point " << i;
      if (std::abs(grid.surface_at(pose.inverse() * Vector3d(at(free.x))).distance) <= error) {
        ++left_out;
        continue;
      }
      EXPECT_LE((at(states[k].v) - at(expected.v)).cwiseAbs().maxCoeff(), error / h + 1e-3)
          << "strand " << k << ", point " << i;
    }
    // The bound is useful: it is half of a hair's radius for 25 points.
    EXPECT_LE(error, 1e-6 * n) << "strand " << k << ", solve " << solve_error << ", stretch " << stretch;
  }
  EXPECT_GT(contacts, 10);
  EXPECT_LE(left_out, 3);
}

}  // namespace
}  // namespace hair::engine
