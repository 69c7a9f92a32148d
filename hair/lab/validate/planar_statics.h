// Strands at rest in the plane y = 0: Newton's method, with the forces' own exact products, finds the balance
// of all forces. It needs strands whose particle 0 is fixed and whose forces keep them in that plane.
//
// The unknowns are (x, z) of particles 1 to n - 1: 2(n - 1) numbers. The matrices are dense: suited for
// hundreds of segments, not for thousands.
#pragma once

#include "hair/strand.h"
#include "particles/force.h"

namespace hair {

// K = -df/dx, N/m, with one call of add_dfdx for each of 10 groups of columns: forces that couple particles
// two apart have five block diagonals. x: 3n.
Eigen::MatrixXd planar_stiffness(const particles::Force& force, particles::Input x);

struct Balance {
  Eigen::VectorXd x;    // 3n, m
  int iterations = 0;   // Newton iterations
  double change = 1;    // the largest one in the last iteration: radians, or parts of a segment
  double residual = 0;  // N, the largest force on a free particle
  double rounding = 0;  // N, the rounding error that `residual` may have
  bool found() const { return residual <= rounding && change <= 1e-9; }
};

// The tip's distance from the origin along x, and its depth below it; NaN if no balance was found.
Eigen::Vector2d tip_of(const Balance& balance);

// Starts from x and uses Newton's method in the segments' angles and lengths. (In positions, a turning
// segment would also stretch, and hair is stiff.) A step turns no segment by more than a radian. So straight
// hair finds its elastica in 4 to 16 steps, without a continuation in the load.
Balance planar_balance(const Strand& strand, const particles::Force& force, Eigen::VectorXd x);

}  // namespace hair
