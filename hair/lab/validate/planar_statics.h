// Strands at rest, in the plane y = 0: where all forces balance, by Newton's method with the forces' own
// exact products. For strands whose particle 0 is held and whose forces keep them in that plane.
//
// Unknowns are (x, z) of particles 1 to n - 1: 2(n - 1) numbers. Dense matrices: for hundreds of segments,
// not for thousands.
#pragma once

#include "hair/strand.h"
#include "particles/force.h"

namespace hair {

// K = -df/dx, N/m, by one product with add_dfdx for each of 10 groups of columns: forces that reach two
// particles far have five diagonals of blocks. x: 3n.
Eigen::MatrixXd planar_stiffness(const particles::Force& force, particles::Input x);

// The frequency of the slowest small oscillation about x in the plane, rad/s; NaN where x is not stable.
double slowest_frequency(const Strand& strand, const particles::Force& force, particles::Input x);

// The last particle: how far it is from the origin along x, and how far down.
Eigen::Vector2d planar_tip(particles::Input x);

struct Balance {
  Eigen::VectorXd x;    // 3n, m
  int iterations = 0;   // of Newton's method
  double change = 1;    // radians, or a part of a segment's length: the most that the last of them changed
  double residual = 0;  // N, the largest force on a free particle
  double rounding = 0;  // N, what of it rounding may leave
  bool found() const { return residual <= rounding && change <= 1e-9; }
};

// Where it puts the tip; NaN, if none was found.
Eigen::Vector2d tip_of(const Balance& balance);

// From x on, by Newton's method in the segments' angles and lengths: straight on, segments that turn would
// stretch, and hair is stiff. A step turns none by more than a radian. So straight hair finds its elastica in
// 4 to 16 steps, without a continuation in the load, and a moment bends it at once.
Balance planar_balance(const Strand& strand, const particles::Force& force, Eigen::VectorXd x);

}  // namespace hair
