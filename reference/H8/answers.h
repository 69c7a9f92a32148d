// STAFF ONLY. H8's hidden cases: their hair of super-helices with its places, sizes for the bounds of errors,
// and a student's answers, asked for through the pipe.
#pragma once

#include "grader/judge/cases/case_asker.h"
#include "grader/judge/cases/random.h"
#include "hair/super_helix/helix_forces.h"
#include "reference/H8/calls.h"

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

// Hair that moves: elements of 5 to 20 mm with natural curvatures of their own, a material like human hair's,
// and a force of its own on each point. Every third point resists more in one direction, as at a contact.
struct Hair {
  VectorXd q, rates;
  HelixStrand strand;
  std::vector<hair::HelixElement> elements;
  std::vector<hair::HelixPoint> points;
};
Hair random_hair(Random& random, const HairKind& kind);

// The same hair, straight along its root's tangent and at rest, with its natural curvatures.
Hair straight_hair(Random& random, int elements);

// The same hair in other units of mass and length: powers of 2, which change no digit.
struct Units {
  double mass = 1, length = 1;
};
Hair in_units(const Hair& hair, const Units& units);
MaterialFrame in_units(MaterialFrame frame, const Units& units);

// For each coordinate the size of a right formula's terms, summed over the points, for any point of the world
// in it: of |J_j force_j|, and the root of the sum of |J_j^T inertia_j J_j|.
struct Sizes {
  VectorXd force, mass;
};
Sizes sizes_of(const Hair& hair);

// M + h^2 K and the right side of the step, from parts.
struct System {
  MatrixXd matrix;
  VectorXd right;

  // The residual in the sense of backward errors; NaN if a number is NaN.
  double error(const VectorXd& change) const;
};
struct Parts {
  MatrixXd M;
  VectorXd Q, K, elastic;  // elastic: - K (q + h q' - q^n)
};
Parts reference_parts(const Hair& hair, double h);
System system_of(const Parts& parts, double h);

// ---- Answers

inline constexpr auto ask_stumpff = answer_of<Calls, hair::stumpff>;
inline constexpr auto ask_frame = answer_of<Calls, hair::frame_at>;
inline constexpr auto ask_jacobian = answer_of<Calls, hair::jacobian_at>;
inline constexpr auto ask_carried = answer_of<Calls, hair::carry_frames>;

inline VectorXd ask_stiffness(Trial& trial, const HelixStrand& strand) {
  return answer_of<Calls, hair::helix_stiffness>(trial, strand, unset(strand.natural.size()));
}
inline VectorXd ask_elastic(Trial& trial, const HelixStrand& strand, const VectorXd& q) {
  return answer_of<Calls, hair::elastic_force>(trial, strand, q, unset(q.size()));
}
inline VectorXd ask_force(Trial& trial, const Hair& hair) {
  return answer_of<Calls, hair::generalised_force>(trial, hair.elements, hair.points, unset(hair.q.size()));
}
inline MatrixXd ask_mass(Trial& trial, const Hair& hair) {
  return answer_of<Calls, hair::mass_matrix>(trial, hair.elements, hair.points,
                                             MatrixXd::Constant(hair.q.size(), hair.q.size(), kUnset));
}
inline VectorXd ask_step(Trial& trial, const Hair& hair, double h) {
  return answer_of<Calls, hair::helix_step>(trial, hair.strand, hair.elements, hair.points, hair.q,
                                            hair.rates, h, Filling{}, unset(hair.q.size()));
}

// True if a student's own number may stand for ours. A strand of 40 elements without the effect of arms still
// has 1e-7 of the right number.
inline bool comparable(double own, double ours) {
  return own >= 1e-9 * ours && own <= 1e9 * ours;
}

}  // namespace grader::h8
