#include "hair/head/bust.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hair/head/bust_parts.h"
#include "hair/head/scalp_roots.h"
#include "hair/strand/variation.h"

namespace hair {
namespace {

Vector3d random_in(const Eigen::AlignedBox3d& box, Variation& variation) {
  const Vector3d part(variation.uniform(0, 1), variation.uniform(0, 1), variation.uniform(0, 1));
  return box.min() + part.cwiseProduct(box.sizes());
}

// Points at most `far` from the surface, from all over the bust.
std::vector<Vector3d> near_surface(const Bust& bust, double far, int count) {
  Variation variation(7);
  std::vector<Vector3d> points;
  while (static_cast<int>(points.size()) < count) {
    Vector3d point = random_in(bust.box(), variation);
    Surface here = bust.surface_at(point);
    if (std::abs(here.distance) > 0.01) continue;
    for (int i = 0; i < 8; ++i, here = bust.surface_at(point)) point -= here.distance * here.normal;
    if (std::abs(here.distance) > 1e-3) continue;  // from deep inside the way may be longer
    points.push_back(point + variation.uniform(-far, far) * here.normal);
  }
  return points;
}

// The error of a central difference over 2 s is s^2 / 6 times the third derivative, which is at most about 1
// / (5 mm)^2. At the begin of a blend, the second derivative jumps by up to 1 / 2k, and the error is s / 4
// times that.
TEST(Bust, TheGradientIsTheDerivative) {
  const Bust bust;
  constexpr double s = 1e-7;
  for (const Vector3d& point : near_surface(bust, 0.01, 2000)) {
    const Vector3d gradient = bust.value_at(point).gradient;
    for (int k = 0; k < 3; ++k) {
      const Vector3d by = s * Vector3d::Unit(k);
      EXPECT_NEAR(gradient[k], (bust.value_at(point + by).value - bust.value_at(point - by).value) / (2 * s),
                  2e-5)
          << point.transpose();
    }
  }
}

TEST(Bust, TheGradientIsContinuousNearTheSurface) {
  const Bust bust;
  Variation variation(3);
  constexpr double far = 0.001, s = 1e-6;
  for (const Vector3d& point : near_surface(bust, far, 1000)) {
    const Vector3d way =
        Vector3d(variation.uniform(-1, 1), variation.uniform(-1, 1), variation.uniform(-1, 1)).normalized();
    Vector3d before = bust.value_at(point - far * way).gradient;
    for (int i = -20; i <= 20; ++i) {
      const Vector3d x = point + i / 20.0 * far * way;
      // The gradient turns by at most 1 / (1 mm) along the way; a jump would not get smaller with s.
      EXPECT_LT((bust.value_at(x + s * way).gradient - bust.value_at(x).gradient).norm(), s / 1e-3)
          << x.transpose();
      const Vector3d here = bust.value_at(x).gradient;
      EXPECT_LT((here - before).norm(), far / 20 / 1e-3) << x.transpose();
      before = here;
    }
    EXPECT_GT(before.norm(), 0.4);
  }
}

TEST(Bust, TheDistanceIsRightToFirstOrderAndHasTheRightSign) {
  const Bust bust;
  for (const Vector3d& point : near_surface(bust, 0, 2000)) {
    const Surface here = bust.surface_at(point);
    EXPECT_NEAR(here.distance, 0, 1e-9);
    EXPECT_NEAR(here.normal.norm(), 1, 1e-14);
    // Half of a curvature of at most 1 / (2 mm), in the creases of the face.
    for (const double d : {1e-4, -1e-4})
      EXPECT_NEAR(bust.surface_at(point + d * here.normal).distance, d, 250 * d * d) << point.transpose();
  }
  // The middle lines of its parts are inside; its box and points beyond it are outside.
  for (const BustPart& part : bust_parts())
    if (!part.carved && part.middle.z() > -0.32) {
      EXPECT_LT(bust.surface_at(part.middle).distance, 0) << part.middle.transpose();
    }
  Variation variation(5);
  for (int i = 0; i < 5000; ++i) {
    Vector3d point = random_in(bust.box(), variation);
    const int side = i % 6;
    point[side / 2] = (side % 2 ? bust.box().min() : bust.box().max())[side / 2];
    EXPECT_GT(bust.surface_at(point).distance, 0) << point.transpose();
    EXPECT_GT(bust.surface_at(Vector3d(3 * point)).distance, 0) << point.transpose();
  }
}

TEST(Bust, ItsSidesAreMirrorImages) {
  const Bust bust;
  const Vector3d mirror(-1, 1, 1);
  for (const Vector3d& point : near_surface(bust, 0.01, 2000)) {
    const Bust::Value here = bust.value_at(point), there = bust.value_at(point.cwiseProduct(mirror));
    EXPECT_EQ(here.value, there.value) << point.transpose();
    EXPECT_EQ(here.gradient.cwiseProduct(mirror), there.gradient) << point.transpose();
  }
}

// Parts far away change nothing near the surface.
TEST(Bust, WhatIsLeftOutIsFarAway) {
  const Bust bust;
  for (const Vector3d& point : near_surface(bust, 0.003, 5000)) {
    const Bust::Value value = bust.value_at(point), all = value_of_parts(point, LeaveOut::nothing);
    EXPECT_EQ(value.value, all.value) << point.transpose();
    EXPECT_EQ(value.gradient, all.gradient) << point.transpose();
  }
}

TEST(Bust, HasTheSizesOfAHead) {
  const Bust bust;
  double wide = 0, front = 0, back = 0;
  const auto outermost = [&](Vector3d from, const Vector3d& way) {
    while (bust.surface_at(from).distance < 0) from += 1e-4 * way;
    return from;
  };
  for (double z = 0.03; z < 0.08; z += 0.005) {
    wide = std::max(wide, 2 * outermost({0, 0.015, z}, Vector3d::UnitX()).x());
    front = std::min(front, outermost({0, 0, z}, -Vector3d::UnitY()).y());
    back = std::max(back, outermost({0, 0, z}, Vector3d::UnitY()).y());
  }
  const double top = outermost({0, 0.012, 0}, Vector3d::UnitZ()).z();
  const double chin = outermost({0, -0.075, -0.1}, -Vector3d::UnitZ()).z();
  EXPECT_NEAR(wide, 0.153, 0.008);
  EXPECT_NEAR(back - front, 0.194, 0.008);
  EXPECT_NEAR(top - chin, 0.23, 0.01);
}

TEST(Bust, RaysToTheScalpLeaveItOnce) {
  const Bust bust;
  for (const RootFrame& root : scalp_roots(bust, 300, 4)) {
    const Vector3d way = (root.position - bust.centre()).normalized();
    const double far = (root.position - bust.centre()).norm();
    for (double s = 0.01; s < 0.5; s += 0.001) {
      if (std::abs(s - far) < 0.001) continue;
      EXPECT_EQ(bust.surface_at(bust.centre() + s * way).distance > 0, s > far) << way.transpose();
    }
  }
}

TEST(Bust, FaceEarsNeckAndShouldersHaveNoHair) {
  const Bust bust;
  const auto towards = [&](double x, double y, double z) {
    return bust.has_hair(bust.surface_towards(Vector3d(x, y, z).normalized()));
  };
  EXPECT_TRUE(towards(0, 0, 1));
  EXPECT_TRUE(towards(0, 1, 0));
  EXPECT_TRUE(towards(1, 0, 0.5));
  EXPECT_TRUE(towards(0, -1, 0.9));
  EXPECT_FALSE(towards(0, -1, 0.2));
  EXPECT_FALSE(towards(0, -1, -0.5));
  EXPECT_FALSE(towards(1, 0, -0.2));
  EXPECT_FALSE(towards(0, 0.1, -1));
  EXPECT_FALSE(towards(1, 0.1, -1));
}

TEST(Bust, HairIsCombedFromThePartingToBothSides) {
  const Bust bust;
  double smoothest = 1, parted = 0;
  for (const RootFrame& root : scalp_roots(bust, 2000, 1)) {
    EXPECT_NEAR(root.side.dot(root.axis), 0, 1e-12);
    EXPECT_NEAR(root.side.norm(), 1, 1e-12);
    const bool near_parting = root.position.y() < kPartingBack && root.position.z() > 0.05 &&
                              std::abs(root.position.x() - kPartingSide) < 0.03;
    if (near_parting) {
      EXPECT_GT(root.side.x() * (root.position.x() - kPartingSide), 0) << root.position.transpose();
      ++parted;
    }
    // At the end of the parting the field begins to fan out, and may turn quickly there.
    const Vector3d end(kPartingSide, kPartingBack, root.position.z());
    if ((root.position - end).norm() < 0.02) continue;
    const Vector3d by = 1e-4 * root.axis.cross(root.side);
    for (const Vector3d& beside : {Vector3d(root.position + by), Vector3d(root.position + 1e-4 * root.side)})
      if ((beside.x() > kPartingSide) == (root.position.x() > kPartingSide))
        smoothest = std::min(smoothest, bust.combed(beside).dot(root.side));
    // Hair falls beside the head.
    if (root.position.z() < 0.02 && std::abs(root.axis.z()) < 0.5) {
      EXPECT_LT(root.side.z(), -0.5) << root.position.transpose();
    }
  }
  EXPECT_GT(parted, 100);
  // In 0.1 mm the field turns by less than 0.02 radians.
  EXPECT_GT(smoothest, std::cos(0.02));
}

}  // namespace
}  // namespace hair
