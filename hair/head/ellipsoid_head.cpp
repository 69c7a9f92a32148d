#include "hair/head/ellipsoid_head.h"

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>
#include <string>

namespace hair {

namespace {

// On the sphere that becomes the ellipsoid by stretching: 40 degrees above the eyes at the forehead, 30 below
// them at the nape.
constexpr double kHalfAngle = 85 * M_PI / 180;
const Vector3d kMiddle(0, std::cos(55 * M_PI / 180), std::sin(55 * M_PI / 180));

}  // namespace

EllipsoidHead::EllipsoidHead(const Vector3d& radii, const Vector3d& centre) : radii_(radii), centre_(centre) {
  if (!(radii.minCoeff() > 0) || !radii.allFinite())
    throw std::invalid_argument("a head has the radius " + std::to_string(radii.minCoeff()) +
                                "; it is above 0");
}

Vector3d EllipsoidHead::surface_towards(const Vector3d& direction) const {
  return centre_ + direction / direction.cwiseQuotient(radii_).norm();
}

Surface EllipsoidHead::surface_at(const Vector3d& point) const {
  const Vector3d q = (point - centre_).cwiseQuotient(radii_);
  const Vector3d gradient = q.cwiseQuotient(radii_);
  const double k = q.norm(), slope = gradient.norm();
  // f = k (k - 1) is 0 on the surface, and there its gradient has the length `slope`.
  return {k * (k - 1) / slope, gradient / slope};
}

bool EllipsoidHead::has_hair(const Vector3d& point) const {
  const Vector3d q = (point - centre_).cwiseQuotient(radii_);
  return q.dot(kMiddle) >= std::cos(kHalfAngle) * q.norm();
}

Vector3d EllipsoidHead::combed(const Vector3d& point) const {
  return surface_at(point).normal.cross(Vector3d::UnitX()).normalized();
}

}  // namespace hair
