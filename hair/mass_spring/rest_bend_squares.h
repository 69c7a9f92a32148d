// The product of Gauss and Newton for hair that is curved at rest, joint by joint.
#pragma once

#include "hair/mass_spring/rest_bend_joint.h"
#include "particles/vectors.h"

namespace hair::rest_bend {

using Eigen::Vector3d;
using particles::Input;

// J^T J dx, joint by joint from the root. J is the derivative of what E is the sum of squares of,
//
//   sqrt(s) (kappa - rest),   sqrt(1 - s) kappa,   sqrt(1 - s) |rest|.
//
// Of the second only what its length does must count. What else kappa does is let in by max(cos(phi), 0), so that
// J is exact on straight hair, and bounded at the fold.
class Squares {
 public:
  explicit Squares(Input dx) : dx_(dx) {}

  Gradient<double> operator()(const Joint<double>& joint);

 private:
  Vector3d turn(int i, const Vector3d& direction, double length) const;

  Input dx_;
  double psi_ = 0;    // how the frame above the joint turns about the strand
  double share_ = 0;  // how log(s) changes
};

}  // namespace hair::rest_bend
