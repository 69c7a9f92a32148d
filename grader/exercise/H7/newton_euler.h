// STAFF ONLY. Whether accelerations obey the laws of motion: without H7's recursion, link by link from Newton's and Euler's
// laws (Mirtich 4.4 and 4.5 solve for the same accelerations).
#pragma once

#include "grader/exercise/H7/trees.h"

namespace grader::h7 {

// The joints' forces that `accelerations` need, beside Q: the largest difference over `size`, the sum of all forces and
// torques that take part, with their arms. M(q) q" = Q - C to within this. NaN if an acceleration is none.
double unbalanced(const Tree& tree, const VectorXd& accelerations);

}  // namespace grader::h7
