// STAFF ONLY. X1: air drag. The contract is in particles/air_drag.h.

#include "particles/air_drag.h"

namespace particles {

void add_air_drag(double coefficient, Input wind, Input v, Output f) {
  for (Eigen::Index i = 0; i < v.size(); i += 3) {
    const Vector3d relative = wind.segment<3>(i) - v.segment<3>(i);
    f.segment<3>(i) += coefficient * relative.norm() * relative;
  }
}

}  // namespace particles
