// STAFF ONLY. Asks a student's functions of H8 through the pipe.
#pragma once

#include "grader/judge/cases/case_asker.h"
#include "reference/H8/calls.h"
#include "reference/H8/hair.h"

namespace grader::h8 {

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
