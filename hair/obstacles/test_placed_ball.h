// STAFF ONLY. A ball as a placed solid, for which the properties of a sphere must hold.
#pragma once

#include <memory>

#include "hair/obstacles/obstacles.h"

namespace hair {

// Its centre is not its own origin, so that turning moves it.
class BesideOrigin : public Solid {
 public:
  explicit BesideOrigin(double radius = 0.1) : radius_(radius) {}

  static Vector3d middle() { return {0.3, 0, 0}; }
  Surface surface_at(const Vector3d& point) const override {
    const Vector3d out = point - middle();
    return {out.norm() - radius_, out.normalized()};
  }
  Eigen::AlignedBox3d box() const override {
    return {Vector3d(middle().array() - radius_), Vector3d(middle().array() + radius_)};
  }

 private:
  double radius_;
};

// The same as Obstacle{Sphere{centre, radius}, friction, velocity}.
inline Obstacle placed_ball(const Vector3d& centre, double radius, double friction = 0,
                            const Vector3d& velocity = Vector3d::Zero()) {
  const Eigen::Quaterniond turned(Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()));
  return {
      PlacedSolid{std::make_shared<BesideOrigin>(radius), centre - turned * BesideOrigin::middle(), turned},
      friction, velocity};
}

}  // namespace hair
