// A bust as in a shop for wigs: head, neck and shoulders as one smooth surface, and its sides are mirror
// images, to the last bit. It is the zero level of a function that joins ellipsoids and capsules, and carves
// the hollows of the eyes out of them. Each joint is a polynomial smooth minimum, with a width k of its own:
//
//   min(a, b) - k h^2 / 4,   h = max(k - |a - b|, 0) / k
//
// (I. Quilez, "smooth minimum", iquilezles.org/articles/smin, the quadratic one). It has a continuous
// gradient. It equals the minimum if a and b differ by k or more, so far parts may be left out. Divided by
// its gradient's length, the function is the distance near the surface.
//
// The sizes are about those of adults: 15 cm wide, 19 cm deep and 23 cm high with the chin, 40 cm across the
// shoulders.
#pragma once

#include "hair/head/head.h"

namespace hair {

class Bust : public Head {
 public:
  // The origin is in the middle of the skull. z up, the face along -y.
  Bust() = default;

  struct Value {
    double value;       // m, below 0 inside
    Vector3d gradient;  // not normalised; longer than 0.4 near the surface
  };
  Value value_at(const Vector3d& point) const;

  Vector3d centre() const override { return {0, 0.015, 0.015}; }
  Vector3d surface_towards(const Vector3d& direction) const override;
  Surface surface_at(const Vector3d& point) const override;
  Eigen::AlignedBox3d box() const override;

  // From the hairline over the forehead, above the ears, and down to the nape.
  bool has_hair(const Vector3d& point) const override;

  // Hair is combed away from a parting, which goes from the forehead to the crown, to both sides and down;
  // behind it to the back and down. The field jumps across the parting; elsewhere it is smooth. On the face
  // it points aside.
  Vector3d combed(const Vector3d& point) const override;

  double on_face(const Vector3d& point) const override;
};

// The parting, as seen from above: from the forehead to the crown.
inline constexpr double kPartingSide = 0.018, kPartingFront = -0.11,
                        kPartingBack = 0.045;  // m: x, and y from, to

}  // namespace hair
