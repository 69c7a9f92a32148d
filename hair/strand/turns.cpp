#include "hair/strand/turns.h"

#include <algorithm>
#include <cmath>

namespace hair {

using Eigen::Quaterniond;

Quaterniond turn_by(const Vector3d& angle) {
  const double size = angle.norm();
  const double part = size > 1e-8 ? std::sin(size / 2) / size : 0.5;
  Quaterniond turn;
  turn.w() = std::cos(size / 2);
  turn.vec() = part * angle;
  return turn;
}

Vector3d turn_of(const Quaterniond& q) {
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

Quaterniond turn_between(const Vector3d& from, const Vector3d& to) {
  const Vector3d a = from.normalized(), b = to.normalized();
  const double cosine = b.dot(a);
  Quaterniond turn;
  if (cosine < -1 + 1e-12) {  // the cross product is rounding
    const double squared = std::max(0.0, (1 + cosine) / 2);
    turn.w() = std::sqrt(squared);
    turn.vec() = std::sqrt(1 - squared) * a.unitOrthogonal();
  } else {
    const double twice = std::sqrt((1 + cosine) * 2);  // 2 cos(angle / 2)
    turn.w() = twice * 0.5;
    turn.vec() = a.cross(b) * (1 / twice);
  }
  return turn;
}

Quaterniond root_axes(const Vector3d& tangent, const Vector3d& normal) {
  Matrix3d axes;
  axes << normal, tangent.cross(normal), tangent;
  return Quaterniond(axes).normalized();
}

}  // namespace hair
