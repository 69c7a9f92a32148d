#include "hair/rigid_links/joint_spring.h"

#include <cmath>

namespace hair {

double JointSpring::energy(double place) const {
  const double too_far = beyond(place);
  return (stiffness(0, 0) * place * place + limit_stiffness * too_far * too_far) / 2;
}

double JointSpring::energy(const Vector3d& theta) const {
  const double too_far = beyond(theta.norm());
  return (theta.dot(stiffness * theta) + limit_stiffness * too_far * too_far) / 2;
}

Vector3d turn_of(const Eigen::Quaterniond& q) {
  const double sine = q.vec().norm(), w = q.w() < 0 ? -q.w() : q.w();
  const double factor = sine > 1e-8 ? 2 * std::atan2(sine, w) / sine : 2;
  return (q.w() < 0 ? -factor : factor) * q.vec();
}

Matrix3d rate_of_turn(const Vector3d& theta) {
  const double squared = theta.squaredNorm(), half = std::sqrt(squared) / 2;
  // 1/12 + theta^2/720 + ...: below 1e-4 rad the second term is rounding.
  const double g = half > 1e-4 ? (1 - half / std::tan(half)) / squared : 1.0 / 12;
  Matrix3d cross;
  cross << 0, -theta.z(), theta.y(), theta.z(), 0, -theta.x(), -theta.y(), theta.x(), 0;
  return (1 - g * squared) * Matrix3d::Identity() - cross / 2 + g * theta * theta.transpose();
}

}  // namespace hair
