// STAFF ONLY. Asks a student's functions of H8.
#include "reference/H8/answers.h"

#include <cmath>

#include "grader/judge/case_asker.h"
#include "reference/H8/calls.h"

namespace grader::h8 {
namespace {

std::string in_words(const Hair& hair) {
  double most = 0;
  for (const hair::HelixElement& element : hair.elements)
    most = std::max(most, element.length * element.curvature.norm());
  return std::to_string(hair.elements.size()) + " elements that wind by " + std::to_string(most) +
         " at most, " + std::to_string(hair.points.size()) + " points";
}

}  // namespace

std::array<double, 8> ask_stumpff(Trial& trial, double x) {
  trial.describe("x = " + std::to_string(x));
  return ask_student_for<Calls, hair::stumpff>(trial, x);
}

MaterialFrame ask_frame(Trial& trial, const MaterialFrame& start, const Vector3d& curvature, double s) {
  trial.describe("an element that winds by " + std::to_string(s * curvature.norm()));
  return ask_student_for<Calls, hair::frame_at>(trial, start, curvature, s);
}

hair::HelixJacobian ask_jacobian(Trial& trial, const MaterialFrame& start, const Vector3d& curvature,
                                 double s) {
  trial.describe("an element that winds by " + std::to_string(s * curvature.norm()));
  return ask_student_for<Calls, hair::jacobian_at>(trial, start, curvature, s);
}

std::vector<hair::HelixElement> ask_carried(Trial& trial, const MaterialFrame& root,
                                            std::vector<hair::HelixElement> elements) {
  trial.describe(std::to_string(elements.size()) + " elements");
  ask_student_for<Calls, hair::carry_frames>(trial, root, elements);
  return elements;
}

VectorXd ask_stiffness(Trial& trial, const HelixStrand& strand) {
  trial.describe(std::to_string(strand.natural.size() / 3) + " elements");
  VectorXd K = unset(strand.natural.size());
  ask_student_for<Calls, hair::helix_stiffness>(trial, strand, K);
  return K;
}

VectorXd ask_elastic(Trial& trial, const HelixStrand& strand, const VectorXd& q) {
  trial.describe(std::to_string(strand.natural.size() / 3) + " elements, bent");
  VectorXd force = unset(q.size());
  ask_student_for<Calls, hair::elastic_force>(trial, strand, q, force);
  return force;
}

VectorXd ask_force(Trial& trial, const Hair& hair) {
  trial.describe(in_words(hair));
  VectorXd Q = unset(hair.q.size());
  ask_student_for<Calls, hair::generalised_force>(trial, hair.elements, hair.points, Q);
  return Q;
}

MatrixXd ask_mass(Trial& trial, const Hair& hair) {
  trial.describe(in_words(hair));
  MatrixXd M = MatrixXd::Constant(hair.q.size(), hair.q.size(), std::nan(""));
  ask_student_for<Calls, hair::mass_matrix>(trial, hair.elements, hair.points, M);
  return M;
}

VectorXd ask_step(Trial& trial, const Hair& hair, double h) {
  trial.describe(in_words(hair) + ", h = " + std::to_string(h) + " s");
  VectorXd change = unset(hair.q.size());
  const Filling scratch{static_cast<int>(hair.q.size()) + 10};
  ask_student_for<Calls, hair::helix_step>(trial, hair.strand, hair.elements, hair.points, hair.q, hair.rates,
                                           h, scratch, change);
  return change;
}

}  // namespace grader::h8
