// The bending of hair that is curved at rest: the energy and force of one joint, and the walk along all
// joints from the root, which passes the frame and the part of it that is kept from each joint to the next.
// rest_curvature.h defines the symbols.
#pragma once

#include <cmath>

#include "hair/mass_spring/dual.h"
#include "hair/strand.h"
#include "particles/vectors.h"

namespace hair::rest_bend {

using Eigen::Vector3d;
using particles::Input;

// Numbers are double, or Dual for derivatives along a direction.
template <typename T>
using Vec3 = Eigen::Matrix<T, 3, 1>;

// q = phi / sin(phi) and -dq/d(cos phi), as functions of the cosine.
template <typename T>
struct Quotient {
  T value, slope;

  Quotient(const T& cosine, const T& sine_squared) {
    using std::atan2, std::sqrt;
    const T z = T(2) * (T(1) - cosine);  // (2 sin(phi/2))^2
    if (value_of(z) < 0.1) {
      // arcsin(t) / (t sqrt(1 - t^2)) = sum (k!)^2 / (2k+1)! (2t)^2k with t = sin(phi/2). Each term is less
      // than a fortieth of the previous one.
      value = T(0);
      slope = T(0);
      double coefficient = 1;
      T power = T(1), last = T(0);  // z^k and z^(k-1)
      for (int k = 0; k < 12; ++k) {
        value += T(coefficient) * power;
        slope += T(2.0 * k * coefficient) * last;
        last = power;
        power *= z;
        coefficient *= (k + 1.0) / (2 * (2 * k + 3.0));
      }
    } else {
      const T sine = sqrt(sine_squared);
      value = atan2(sine, cosine) / sine;
      slope = (T(1) - value * cosine) / sine_squared;
    }
  }
};

// The part of the frame that a joint keeps, and the derivative of its logarithm by cos(phi): c = y^2 (3 -
// 2y), from 1 at phi = 2.69 down to 0 at 3.00. With `one_plus` = 1 + cos(phi).
template <typename T>
struct Kept {
  T value = T(1), slope = T(0);

  Kept() = default;
  explicit Kept(const T& one_plus) {
    constexpr double kFrom = 0.1, kTo = 0.01;
    const T y = (one_plus - T(kTo)) / T(kFrom - kTo);
    if (value_of(y) >= 1) return;
    value = T(0);
    if (value_of(y) <= 0) return;
    value = y * y * (T(3) - T(2) * y);
    slope = T(6 / (kFrom - kTo)) * (T(1) - y) / (y * (T(3) - T(2) * y));
  }
};

// A joint, and the frame of the segment above it.
template <typename T>
struct Joint {
  int above = -1, below = 0;  // its segments; above is -1 at the root
  Vec3<T> u, v;               // their directions
  T length_above = T(1), length_below = T(1);
  Vec3<T> second, third;  // the frame's other two vectors; its first one is u
  T cosine = T(1), one_plus_cosine = T(2);
  bool folded = false;
  double stiffness = 0;
  T kappa[2] = {T(0), T(0)}, off[2] = {T(0), T(0)};  // components of w, and their difference from rest
  double rest[2] = {0, 0};
  Kept<T> kept;    // the part that this joint keeps
  T share = T(1);  // s: the product of the kept parts of all joints from the root to this one

  bool is_obtuse() const { return value_of(cosine) < 0; }
  double rest_squared() const { return rest[0] * rest[0] + rest[1] * rest[1]; }

  // Not set at the fold:
  T q = T(1), slope = T(0);
  Vec3<T> u_x_v, w, tan_b;  // phi b and tan(phi/2) b
  Vec3<T> b;                // only if the joint is obtuse

  // The derivative of |off|^2 / 2 by a rotation of the frame about the strand, with off = by.
  T turn(const T by[2]) const { return kappa[0] * by[1] - kappa[1] * by[0]; }
};

// A derivative of the energy by the joint's quantities, without its stiffness.
template <typename T>
struct Gradient {
  T turning[2] = {T(0), T(0)};  // by kappa, the part that depends on the frame
  T bending[2] = {T(0), T(0)};  // by kappa, the part that depends only on the angle
  T share = T(0);               // by log(s)
};

// E / k = s |kappa - rest|^2 / 2 + (1 - s) (|kappa|^2 + |rest|^2) / 2, times k.
inline double energy(const Joint<double>& joint) {
  const double s = joint.share;
  const double kept = joint.off[0] * joint.off[0] + joint.off[1] * joint.off[1];
  const double lost =
      joint.kappa[0] * joint.kappa[0] + joint.kappa[1] * joint.kappa[1] + joint.rest_squared();
  const double squared = s * kept + (1 - s) * lost;
  return joint.stiffness * squared / 2;
}

// The gradient of that energy.
template <typename T>
Gradient<T> energy_gradient(const Joint<T>& joint) {
  Gradient<T> gradient;
  for (int i = 0; i < 2; ++i) {
    gradient.turning[i] = joint.share * joint.off[i];
    gradient.bending[i] = (T(1) - joint.share) * joint.kappa[i];
    gradient.share -= joint.share * joint.kappa[i] * T(joint.rest[i]);
  }
  return gradient;
}

// Calls add(particle, force) with the joint's forces, minus its gradient. `turn` is the sum over the joints
// below it; `share` also includes the joint itself.
template <typename T, typename Add>
void spread(const Joint<T>& joint, const Gradient<T>& gradient, const T& turn, const T& share, Add add) {
  if (joint.folded) return;
  const T k = T(joint.stiffness);
  Vec3<T> error = joint.second * gradient.turning[0] + joint.third * gradient.turning[1];
  const Vec3<T> bend = joint.second * gradient.bending[0] + joint.third * gradient.bending[1];
  // All frames below turn with either segment, and all kept parts below change with the angle.
  Vec3<T> by_u = joint.tan_b * turn, by_v = by_u;
  by_u += joint.v * (joint.kept.slope * share);
  by_v += joint.u * (joint.kept.slope * share);
  if (joint.is_obtuse()) {
    // Near the fold only the component along b avoids cancellation of large numbers.
    const T along = joint.b.dot(error);
    const T angle = (along + joint.b.dot(bend)) * k;
    error -= joint.b * along;
    by_u += joint.v.cross(error) * (joint.q * k) - joint.b.cross(joint.u) * angle;
    by_v += error.cross(joint.u) * (joint.q * k) + joint.b.cross(joint.v) * angle;
  } else {
    error += bend;
    const T along = error.dot(joint.u_x_v) * joint.slope;
    by_u += (joint.v.cross(error) * joint.q - joint.v * along) * k;
    by_v += (error.cross(joint.u) * joint.q - joint.u * along) * k;
  }
  auto add_to_segment = [&](int i, const Vec3<T>& direction, const T& length, const Vec3<T>& by) {
    const Vec3<T> pull = (by - direction * direction.dot(by)) / length;
    add(i, pull);
    add(i + 1, Vec3<T>(-pull));
  };
  if (joint.above >= 0) add_to_segment(joint.above, joint.u, joint.length_above, by_u);
  add_to_segment(joint.below, joint.v, joint.length_below, by_v);
}

// The vector of segment i.
inline Vector3d difference(Input x, int i) {
  return x.segment<3>(3 * i + 3) - x.segment<3>(3 * i);
}

// Calls visit(joint) for all joints that have an angle, from the root to the tip. segment(i) is the vector of
// segment i.
template <typename T, typename Segment, typename Visit>
void walk(const Strand& strand, const Eigen::VectorXd& rest, const Vector3d& root_normal, Segment segment,
          Visit visit) {
  using std::sqrt;
  Joint<T> joint;
  joint.v = joint.third = joint.u_x_v = joint.w = joint.tan_b = joint.b = Vec3<T>::Zero();
  joint.u = strand.root_tangent.cast<T>();
  joint.second = root_normal.cast<T>();
  bool meets = true;  // no segment of length 0 since the segment above
  for (int i = 0; i < strand.segments(); ++i) {
    const Vec3<T> e = segment(i);
    const T squared = e.dot(e);
    if (value_of(squared) == 0) {
      meets = false;
      continue;
    }
    joint.below = i;
    joint.length_below = sqrt(squared);
    joint.v = e / joint.length_below;
    joint.third = joint.u.cross(joint.second);
    joint.u_x_v = joint.u.cross(joint.v);
    joint.cosine = joint.u.dot(joint.v);
    const T sine_squared = joint.u_x_v.dot(joint.u_x_v);
    const Vec3<T> bisector = joint.u + joint.v;
    joint.one_plus_cosine = bisector.dot(bisector) / T(2);  // accurate near the fold too
    joint.folded = joint.is_obtuse() && value_of(sine_squared) == 0;
    joint.kept = Kept<T>(joint.one_plus_cosine);
    joint.share *= joint.kept.value;
    if (joint.folded) {
      joint.kappa[0] = T(EIGEN_PI);
      joint.kappa[1] = T(0);
    } else {
      const Quotient<T> quotient(joint.cosine, sine_squared);
      joint.q = quotient.value;
      joint.slope = quotient.slope;
      if (joint.is_obtuse()) joint.b = joint.u_x_v / sqrt(sine_squared);
      joint.w = joint.u_x_v * joint.q;
      joint.tan_b = joint.u_x_v / joint.one_plus_cosine;
      joint.kappa[0] = joint.w.dot(joint.second);
      joint.kappa[1] = joint.w.dot(joint.third);
    }
    for (int k = 0; k < 2; ++k) {
      joint.rest[k] = rest[2 * i + k];
      joint.off[k] = joint.kappa[k] - T(joint.rest[k]);
    }
    const double l =
        i == 0 ? strand.rest_length[0] / 2 : (strand.rest_length[i - 1] + strand.rest_length[i]) / 2;
    joint.stiffness = strand.bend_rigidity / l;
    if (meets) visit(joint);

    // Passes the frame to the segment below: the minimal rotation from u to v (about `second` at the fold).
    // Then makes it perpendicular again, because rounding errors sum up along the strand.
    if (!joint.folded) joint.second -= bisector * (joint.v.dot(joint.second) / joint.one_plus_cosine);
    joint.second -= joint.v * joint.v.dot(joint.second);
    joint.second = joint.second / sqrt(joint.second.dot(joint.second));
    joint.u = joint.v;
    joint.length_above = joint.length_below;
    joint.above = i;
    meets = true;
  }
}

// Sums over all joints below: the frames' turns, and the derivatives by the kept parts.
template <typename T>
struct Below {
  T turn = T(0), share = T(0);

  void add(const Joint<T>& joint, const Gradient<T>& gradient, double sign) {
    turn += T(sign * joint.stiffness) * joint.turn(gradient.turning);
    share += T(sign * joint.stiffness) * gradient.share;
  }
};

// Calls add(particle, force) with the forces of all joints. It makes two walks from the root; `first` and
// `second` return a joint's gradient in the first and in the second walk.
template <typename T, typename Segment, typename First, typename Second, typename Add>
void spread_all(const Strand& strand, const Eigen::VectorXd& rest, const Vector3d& root_normal,
                Segment segment, First first, Second second, Add add) {
  Below<T> below;
  walk<T>(strand, rest, root_normal, segment,
          [&](const Joint<T>& joint) { below.add(joint, first(joint), 1); });
  walk<T>(strand, rest, root_normal, segment, [&](const Joint<T>& joint) {
    const Gradient<T> gradient = second(joint);
    const T share = below.share;
    below.add(joint, gradient, -1);
    spread(joint, gradient, below.turn, share, add);
  });
}

}  // namespace hair::rest_bend
