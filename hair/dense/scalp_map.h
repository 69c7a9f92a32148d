// A scalp as a plane map, to triangulate its roots: Lambert's azimuthal projection. A root's distance from
// the map's middle is the straight distance from the apex, and its direction the one along the scalp. A plane
// is not changed, and a sphere keeps its areas; its far side, opposite to the apex, becomes the map's rim. J.
// H. Lambert, "Anmerkungen und Zusaetze zur Entwerfung der Land- und Himmelscharten" (1772).
#pragma once

#include <vector>

#include "hair/strand/rest_shape.h"

namespace hair {

class ScalpMap {
 public:
  // The apex is the root whose normal is nearest to the mean of all normals; if there are several, the one in
  // the middle. roots: at least one; axis: the normal.
  explicit ScalpMap(const std::vector<RootFrame>& roots);

  Eigen::Vector2d at(const Vector3d& root) const;
  const Vector3d& pole() const { return pole_; }  // the apex's normal

 private:
  Vector3d apex_, pole_, x_, y_;
};

}  // namespace hair
