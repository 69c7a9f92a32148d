// A strand: n particles on a line, n >= 1, and n - 1 segments between them. Segment i joins particles i and
// i + 1, joint i (0 < i < n - 1) is where segments i - 1 and i meet, and particle 0 is the root.
//
//   0 ---- 1 ---- 2 ---- ... ---- n-1
//      0      1      2        n-2          segments
//
// The constants are those of the continuum, EA and EI, not spring constants. The spring constant of a segment
// or joint follows from them and from the lengths, so that a strand has the same energy with any number of
// segments: the lecture's k_i ~ 1/l_i.
#pragma once

#include <Eigen/Core>

namespace hair {

struct Strand {
  Eigen::VectorXd mass;         // n, kg, > 0; in a uniform strand half of the mass of the adjacent segments
  Eigen::VectorXd rest_length;  // n - 1, m, > 0
  double stretch_rigidity = 0;  // EA, N
  double bend_rigidity = 0;     // EI, N m^2
  double skip_rigidity = 0;     // N: of springs that skip a particle, the alternative to bend_rigidity

  // Clamped: the strand leaves the root in the direction root_tangent (of length 1), under any force.
  // Otherwise the root is a hinge.
  bool clamped = false;
  Eigen::Vector3d root_tangent = Eigen::Vector3d(0, 0, -1);

  int count() const { return static_cast<int>(mass.size()); }            // n
  int segments() const { return static_cast<int>(rest_length.size()); }  // n - 1
};

}  // namespace hair
