#include "hair/mass_spring/rest_bend_squares.h"

#include <algorithm>
#include <cmath>

#include "hair/mass_spring/rest_bend_walk.h"

namespace hair::rest_bend {

Gradient<double> Squares::operator()(const Joint<double>& joint) {
  Gradient<double> gradient;
  if (joint.folded) {
    share_ = psi_ = 0;  // nothing is left of either
    return gradient;
  }
  const Vector3d du = joint.above < 0 ? Vector3d::Zero() : turn(joint.above, joint.u, joint.length_above);
  const Vector3d dv = turn(joint.below, joint.v, joint.length_below);
  const double dcos = du.dot(joint.v) + joint.u.dot(dv);
  share_ += joint.kept.slope * dcos;  // d log(s)
  Vector3d dw = (du.cross(joint.v) + joint.u.cross(dv)) * joint.q;
  double dphi = 0;
  if (joint.is_obtuse()) {
    dphi = joint.b.dot(joint.v.cross(dv) - joint.u.cross(du));
    dw += joint.b * (dphi - joint.b.dot(dw));
  } else {
    dw -= joint.u_x_v * (joint.slope * dcos);
  }
  const double dkappa[2] = {dw.dot(joint.second), dw.dot(joint.third)};
  const double frame[2] = {psi_ * joint.kappa[1], -psi_ * joint.kappa[0]};
  psi_ -= joint.tan_b.dot(du + dv);

  const double s = joint.share, root = std::sqrt(s), rest = std::sqrt(1 - s);
  const double fading = s < 1 ? s * share_ / (2 * rest) : 0;  // -d sqrt(1 - s)
  double by_share = 0;
  for (int i = 0; i < 2; ++i) {
    const double a = s > 0 ? root * (dkappa[i] + frame[i] + joint.off[i] * share_ / 2) : 0;
    gradient.turning[i] = root * a;
    by_share += root / 2 * joint.off[i] * a;
  }
  if (s < 1) {
    const double phi_squared = joint.kappa[0] * joint.kappa[0] + joint.kappa[1] * joint.kappa[1];
    const double across = std::max(joint.cosine, 0.0);
    const auto damped = [&](const double from[2], int i) {
      if (joint.is_obtuse() || phi_squared == 0) return across * from[i];
      const double along = joint.kappa[0] * from[0] + joint.kappa[1] * from[1];
      return across * from[i] + (1 - across) / phi_squared * along * joint.kappa[i];
    };
    const double phi = std::sqrt(phi_squared);
    double b[2];
    for (int i = 0; i < 2; ++i)
      b[i] = rest * (joint.is_obtuse() ? dphi * joint.kappa[i] / phi : damped(dkappa, i)) -
             joint.kappa[i] * fading;
    for (int i = 0; i < 2; ++i) {
      gradient.bending[i] = rest * (joint.is_obtuse() ? b[i] : damped(b, i));
      by_share -= s / (2 * rest) * joint.kappa[i] * b[i];
    }
    by_share += s / (2 * rest) * joint.rest_squared() * fading;
  }
  gradient.share = by_share;
  return gradient;
}

Vector3d Squares::turn(int i, const Vector3d& direction, double length) const {
  const Vector3d de = difference(dx_, i);
  return (de - direction * direction.dot(de)) / length;
}

}  // namespace hair::rest_bend
