// STAFF ONLY. A student's functions of H8, requested through the pipe.
#pragma once

#include "grader/judge/trial.h"
#include "reference/H8/hair.h"

namespace grader::h8 {

std::array<double, 8> ask_stumpff(Trial& trial, double x);
MaterialFrame ask_frame(Trial& trial, const MaterialFrame& start, const Vector3d& curvature, double s);
hair::HelixJacobian ask_jacobian(Trial& trial, const MaterialFrame& start, const Vector3d& curvature,
                                 double s);
std::vector<hair::HelixElement> ask_carried(Trial& trial, const MaterialFrame& root,
                                            std::vector<hair::HelixElement> elements);
VectorXd ask_stiffness(Trial& trial, const HelixStrand& strand);
VectorXd ask_elastic(Trial& trial, const HelixStrand& strand, const VectorXd& q);
VectorXd ask_force(Trial& trial, const Hair& hair);
MatrixXd ask_mass(Trial& trial, const Hair& hair);
VectorXd ask_step(Trial& trial, const Hair& hair, double h);

// Whether a student's own number may stand for ours. That of a strand of 40 elements that lacks what arms do is 1e-7 of what it
// should be.
inline bool comparable(double own, double ours) {
  return own >= 1e-9 * ours && own <= 1e9 * ours;
}

}  // namespace grader::h8
