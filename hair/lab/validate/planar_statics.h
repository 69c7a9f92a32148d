// Strands at rest in the plane y = 0: Newton's method, with the forces' own exact products, finds the balance
// of all forces. It needs strands whose particle 0 is fixed and whose forces keep them in that plane.
//
// The unknowns are (x, z) of particles 1 to n - 1: 2(n - 1) numbers. The matrices are dense: suited for
// hundreds of segments, not for thousands.
#pragma once

#include "hair/strand.h"
#include "particles/force.h"

namespace hair {

// K = -df/dx, N/m. x: 3n.
Eigen::MatrixXd planar_stiffness(const particles::Force& force, particles::Input x);

// The tip's distance from the origin along x, and its depth below it, where all forces are in balance; NaN if
// no balance was found.
//
// Starts from x and uses Newton's method in the segments' angles and lengths. (In positions, a turning
// segment would also stretch, and hair is stiff.) A step turns no segment by more than a radian. So straight
// hair finds its elastica in 4 to 16 steps, without a continuation in the load.
Eigen::Vector2d tip_in_balance(const Strand& strand, const particles::Force& force, Eigen::VectorXd x);

}  // namespace hair
