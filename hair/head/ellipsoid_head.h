// A head that is an ellipsoid, (x / a)^2 + (y / b)^2 + (z / c)^2 = 1 from its centre. Its scalp is what a cap
// of a sphere becomes; it goes from the forehead to the nape. Hair is combed from the forehead over the crown
// to the nape, on the ways of a rotation about the axis through the ears: the field has no other singular
// points than these two, and the cap, of less than half of the sphere, leaves both out.
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
