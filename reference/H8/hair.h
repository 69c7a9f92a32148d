// STAFF ONLY. Inputs of H8's hidden cases: hair of super-helices as it lies, and the sizes of what is
// calculated of it.
#pragma once

#include "grader/judge/random.h"
#include "hair/super_helix/helix_forces.h"

namespace grader::h8 {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using hair::HelixMotion, hair::HelixStrand, hair::MaterialFrame, hair::Matrix3d, hair::Vector3d;

Vector3d any_direction(Random& random);
MaterialFrame any_frame(Random& random);

struct HairKind {
  int elements;
  double least = 0.3, most = 3;  // rad, by which an element winds
};

// Hair that moves: elements of 5 to 20 mm, a material about that of human hair, natural curvatures of their
// own, and points that are pushed each in its way. Every third point resists more in one direction, as at a
// contact.
struct Hair {
  VectorXd q, rates;
  HelixStrand strand;
  std::vector<hair::HelixElement> elements;
  std::vector<hair::HelixPoint> points;
};
Hair random_hair(Random& random, const HairKind& kind);

// The same lying straight along its root's tangent, at rest; its natural curvatures are what they were.
Hair straight_hair(Random& random, int elements);

// The same hair in other units of mass and length: powers of 2, which change no digit.
struct Units {
  double mass = 1, length = 1;
};
Hair in_units(const Hair& hair, const Units& units);
MaterialFrame in_units(MaterialFrame frame, const Units& units);

// For each coordinate, sums over the points of what a right formula adds up, whatever point of the world it
// refers to: of |J_j force_j|, and the root of the sum of |J_j^T inertia_j J_j|.
struct Sizes {
  VectorXd force, mass;
};
Sizes sizes_of(const Hair& hair);

// M + h^2 K and the right side of the step, from parts.
struct System {
  MatrixXd matrix;
  VectorXd right;

  // The residual in the sense of backward errors; NaN if a number is none.
  double error(const VectorXd& change) const;
};
struct Parts {
  MatrixXd M;
  VectorXd Q, K, elastic;  // elastic: - K (q + h q' - q^n)
};
Parts reference_parts(const Hair& hair, double h);
System system_of(const Parts& parts, double h);

}  // namespace grader::h8
