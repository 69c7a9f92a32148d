// All joints of a strand that is curved at rest, from the root on. A frame, and the share of it that is kept, pass
// from each joint to the next.
#pragma once

#include <cmath>

#include "hair/mass_spring/rest_bend_joint.h"
#include "particles/vectors.h"

namespace hair::rest_bend {

using Eigen::Vector3d;
using particles::Input;

// The vector of segment i.
inline Vector3d difference(Input x, int i) {
  return x.segment<3>(3 * i + 3) - x.segment<3>(3 * i);
}

// Calls visit(joint) for all joints that have an angle, from the root. segment(i) is the vector of segment i.
template <typename T, typename Segment, typename Visit>
void walk(const Strand& strand, const Eigen::VectorXd& rest, const Vector3d& root_normal, Segment segment,
          Visit visit) {
  using std::sqrt;
  Joint<T> joint;
  joint.v = joint.third = joint.u_x_v = joint.w = joint.tan_b = joint.b = Vec3<T>::Zero();
  joint.u = strand.root_tangent.cast<T>();
  joint.second = root_normal.cast<T>();
  bool meets = true;  // nothing of length 0 since the segment above
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
    joint.one_plus_cosine = bisector.dot(bisector) / T(2);  // with all digits, next to the fold too
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

    // The frame goes on to the segment below: minimal rotation from u to v (about `second` at the fold). Made
    // perpendicular again, for roundings add up along the strand.
    if (!joint.folded) joint.second -= bisector * (joint.v.dot(joint.second) / joint.one_plus_cosine);
    joint.second -= joint.v * joint.v.dot(joint.second);
    joint.second = joint.second / sqrt(joint.second.dot(joint.second));
    joint.u = joint.v;
    joint.length_above = joint.length_below;
    joint.above = i;
    meets = true;
  }
}

// What all frames and shares of joints below add up to.
template <typename T>
struct Below {
  T turn = T(0), share = T(0);

  void add(const Joint<T>& joint, const Gradient<T>& gradient, double sign) {
    turn += T(sign * joint.stiffness) * joint.turn(gradient.turning);
    share += T(sign * joint.stiffness) * gradient.share;
  }
};

// Calls add(particle, force) with what all joints pull. Two walks: gradients are asked for twice, `first` and `second`,
// each time from the root on.
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
