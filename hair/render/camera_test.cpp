#include "hair/render/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

namespace hair {
namespace {

// The largest |x| and |y| of the box's corners in the picture, whose edge is 1, calculated here
// independently.
Eigen::Vector2d extent(const Camera& camera, const Bounds& box, double aspect) {
  const Vector3d forward = (camera.target - camera.eye).normalized();
  const Vector3d right = forward.cross(camera.up).normalized(), up = right.cross(forward);
  Eigen::Vector2d most(0, 0);
  for (const Vector3d& corner : corners_of(box)) {
    const Vector3d at = corner - camera.eye;
    EXPECT_GT(at.dot(forward), 0) << "behind the eye";
    const double half = std::tan(camera.field_of_view / 2) * at.dot(forward);
    most[0] = std::max(most[0], std::abs(at.dot(right)) / (half * aspect));
    most[1] = std::max(most[1], std::abs(at.dot(up)) / half);
  }
  return most;
}

TEST(Camera, HasTheWholeBoxInThePictureAndNoNearerEyeWould) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto vector = [&] { return Vector3d(uniform(random), uniform(random), uniform(random)); };
  for (int i = 0; i < 500; ++i) {
    const double size = std::pow(10, 6 * uniform(random)), aspect = std::exp(uniform(random));
    Bounds box;
    box.extend(size * vector());
    box.extend(size * vector());
    const Camera camera = frame_camera(box, aspect, i % 10 == 0 ? Vector3d(0, 0, 1) : vector());
    // In one direction both sides touch the frame, in the other neither may be outside. Coordinates as large
    // as the box have rounding errors of 1e-16 of it.
    EXPECT_NEAR(extent(camera, box, aspect).maxCoeff(), kFramed, 1e-9)
        << "case " << i << ", aspect " << aspect;
  }
}

// Points on a ball: none is outside of the frame, and the camera is nearer than for the box around it.
TEST(Camera, HasAllPointsInThePicture) {
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  std::vector<Vector3d> points;
  Bounds box;
  for (int i = 0; i < 500; ++i) {
    points.push_back(Vector3d(normal(random), normal(random), normal(random)).normalized());
    box.extend(points.back());
  }
  for (const double aspect : {0.5, 1.0, 1.8}) {
    const Camera camera = frame_points(points, aspect), far = frame_camera(box, aspect);
    Eigen::Vector2d most(0, 0);
    for (const Vector3d& point : points) {
      Bounds one;
      one.extend(point);
      most = most.cwiseMax(extent(camera, one, aspect));
    }
    EXPECT_NEAR(most.maxCoeff(), kFramed, 1e-9) << aspect;
    EXPECT_LT((camera.eye - camera.target).norm(), 0.9 * (far.eye - far.target).norm());
  }
}

TEST(Camera, WhatHasNoSizeIsSeenFromNearby) {
  Bounds point;
  point.extend(Vector3d(1, 2, 3));
  for (const Bounds& box : {point, Bounds()}) {
    const Camera camera = frame_camera(box, 1.5);
    const double distance = (camera.eye - camera.target).norm();
    EXPECT_GT(distance, 1e-3);
    EXPECT_LT(distance, 0.1);
  }
}

TEST(Camera, RefusesWhatIsNotFinite) {
  Bounds box;
  box.extend(Vector3d(0, 0, 0));
  box.extend(Vector3d(1, 1, 1));
  EXPECT_THROW(frame_camera(box, 0), std::invalid_argument);
  EXPECT_THROW(frame_camera(box, 1, Vector3d::Zero()), std::invalid_argument);
  box.extend(Vector3d(std::numeric_limits<double>::infinity(), 0, 0));
  EXPECT_THROW(frame_camera(box, 1), std::invalid_argument);
}

}  // namespace
}  // namespace hair
