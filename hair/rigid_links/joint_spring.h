// A spring and a damper at a joint. The energy of a spherical joint that is turned by the vector theta (rad,
// at most pi long) against its rest is
//
//   E = theta^T K theta / 2      theta = 2 atan2(|v|, w) v / |v|  of its quaternion, w + v, with w >= 0
//
// theta has the same components along the axes at rest (q = 0) and along the turned ones: the spring treats
// its two links alike. As w, the angular velocity between the links, turns the joint,
//
//   theta' = A w,   A = 1 - theta~ / 2 + g theta~^2,   g = (1 - |theta| / 2 cot(|theta| / 2)) / |theta|^2
//
// (J. E. Bortz, "A New Mathematical Formulation for Strapdown Inertial Navigation", IEEE Transactions on
// Aerospace and Electronic Systems 7 (1971)), so its torque is -A^T K theta. At half a turn the torque
// changes its sign, because the opposite way back is shorter then.
//
// A revolute or prismatic joint uses only the number K[0, 0].
//
// A limit is a spring of its own, which acts only beyond it, like an elastic buffer. Its energy is
// limit_stiffness (|theta| - upper)^2 / 2 for |theta| > upper; for revolute and prismatic joints the same
// below `lower`.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <limits>

#include "hair/strand/turns.h"

namespace hair {

struct JointSpring {
  Matrix3d stiffness =
      Matrix3d::Zero();                 // K, N m/rad or N/m, along the joint's axes at rest; symmetric, >= 0
  Matrix3d damping = Matrix3d::Zero();  // C, N m s/rad or N s/m: the same
  double lower = -std::numeric_limits<double>::infinity();  // rad or m; not for spherical joints
  double upper = std::numeric_limits<double>::infinity();   // rad or m
  double limit_stiffness = 0;                               // N m/rad or N/m, >= 0

  // The distance of a joint beyond its limits; negative below `lower`, 0 between them.
  double beyond(double place) const {
    return place > upper ? place - upper : place < lower ? place - lower : 0;
  }

  // J.
  double energy(double place) const;
  double energy(const Vector3d& theta) const;
};

}  // namespace hair
