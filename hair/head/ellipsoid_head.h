// A head that is an ellipsoid, (x / a)^2 + (y / b)^2 + (z / c)^2 = 1 around its centre. Its scalp is the
// image of a spherical cap, from the forehead to the nape. Hair is combed from the forehead over the crown to
// the nape, along the circles of a rotation about the axis through the ears. The field is singular only at
// the ears, and the cap, which is less than half of the sphere, contains neither.
#pragma once

#include "hair/head/head.h"

namespace hair {

class EllipsoidHead : public Head {
 public:
  // Throws std::invalid_argument for a radius that is not above 0.
  explicit EllipsoidHead(const Vector3d& radii = {0.076, 0.096, 0.112},
                         const Vector3d& centre = Vector3d::Zero());

  Vector3d centre() const override { return centre_; }
  Vector3d surface_towards(const Vector3d& direction) const override;
  Surface surface_at(const Vector3d& point) const override;
  Eigen::AlignedBox3d box() const override { return {centre_ - radii_, centre_ + radii_}; }
  bool has_hair(const Vector3d& point) const override;
  Vector3d combed(const Vector3d& point) const override;

 private:
  Vector3d radii_, centre_;
};

}  // namespace hair
