#include "hair/rigid_links/joint_spring.h"

namespace hair {

double JointSpring::energy(double place) const {
  const double too_far = beyond(place);
  return (stiffness(0, 0) * place * place + limit_stiffness * too_far * too_far) / 2;
}

double JointSpring::energy(const Vector3d& theta) const {
  const double too_far = beyond(theta.norm());
  return (theta.dot(stiffness * theta) + limit_stiffness * too_far * too_far) / 2;
}

}  // namespace hair
