// STAFF ONLY. A right H2 in long double and without an axis, but where S asks for one: with kappa = cos phi and
// r = phi / sin phi, which is smooth at 0,
//
//   phi dphi/de1 = -r (u2 - kappa u1) / l1,    phi dphi/de2 = r (kappa u2 - u1) / l2,
//   dr/dkappa = -(sin phi - phi cos phi) / sin^3 phi.
#include "hair/angular_springs.h"

#include <algorithm>
#include <cmath>

namespace hair {
namespace {

using Real = long double;
using Long3 = Eigen::Matrix<Real, 3, 1>;

Long3 segment(Input x, int i) {
  return x.segment<3>(3 * i + 3).cast<Real>() - x.segment<3>(3 * i).cast<Real>();
}

struct Joint {
  Real k = 0, l1 = 0, l2 = 0;
  Long3 u1, u2;
  Real phi = 0, sine = 0, kappa = 1;

  bool has_angle() const { return l1 > 0 && l2 > 0; }
  bool acts() const { return has_angle() && (sine > 0 || kappa > 0); }

  Real r() const { return sine > 0 ? phi / sine : 1; }
  Real slope_of_r() const {
    const Real square = phi * phi;
    if (phi < 1e-3L)
      return -(1 - square / 10 + square * square / 280) / (3 - square * 3 / 2 + square * square * 39 / 120);
    return -(sine - phi * kappa) / (sine * sine * sine);
  }
};

// i: the segment behind the joint.
Joint joint(const Strand& strand, Input x, int i) {
  Joint joint;
  const Long3 e1 = i > 0 ? segment(x, i - 1) : Long3(strand.root_tangent.cast<Real>()), e2 = segment(x, i);
  const Real before = i > 0 ? strand.rest_length[i - 1] : 0, behind = strand.rest_length[i];
  joint.k = 2 * strand.bend_rigidity / (before + behind);
  joint.l1 = e1.norm();
  joint.l2 = e2.norm();
  if (!joint.has_angle()) return joint;
  joint.u1 = e1 / joint.l1;
  joint.u2 = e2 / joint.l2;
  joint.sine = e1.cross(e2).norm() / (joint.l1 * joint.l2);
  joint.kappa = joint.u1.dot(joint.u2);
  joint.phi = std::atan2(joint.sine, joint.kappa);
  return joint;
}

struct Pair {
  Long3 first, second;  // what belongs to e1, and to e2
};

// The change of a joint's segments that dx makes. The root's direction is fixed.
Pair changes(Input dx, int i) {
  return {i > 0 ? segment(dx, i - 1) : Long3(Long3::Zero()), segment(dx, i)};
}

// f -= what a gradient in e1 and e2 is in x.
void subtract(int i, const Pair& gradient, Output f) {
  if (i > 0) f.segment<3>(3 * i - 3) += gradient.first.cast<double>();
  f.segment<3>(3 * i) += (gradient.second - (i > 0 ? gradient.first : Long3(Long3::Zero()))).cast<double>();
  f.segment<3>(3 * i + 3) -= gradient.second.cast<double>();
}

template <typename Function>
void each_joint(const Strand& strand, Input x, const Function& function) {
  for (int i = strand.clamped ? 0 : 1; i < strand.segments(); ++i) function(i, joint(strand, x, i));
}

}  // namespace

double bend_energy(const Strand& strand, Input x) {
  Real E = 0;
  each_joint(strand, x, [&](int, const Joint& at) { E += at.k * at.phi * at.phi / 2; });
  return static_cast<double>(E);
}

void add_bend_force(const Strand& strand, Input x, Output f) {
  each_joint(strand, x, [&](int i, const Joint& at) {
    if (!at.acts()) return;
    const Real kr = at.k * at.r();
    subtract(i, {-kr / at.l1 * (at.u2 - at.kappa * at.u1), kr / at.l2 * (at.kappa * at.u2 - at.u1)}, f);
  });
}

void add_bend_product(const Strand& strand, Input x, Input dx, Output df) {
  each_joint(strand, x, [&](int i, const Joint& at) {
    if (!at.acts()) return;
    const auto [de1, de2] = changes(dx, i);
    const Real dl1 = at.u1.dot(de1), dl2 = at.u2.dot(de2), r = at.r();
    const Long3 du1 = (de1 - dl1 * at.u1) / at.l1, du2 = (de2 - dl2 * at.u2) / at.l2;
    const Real dkappa = du1.dot(at.u2) + at.u1.dot(du2), dr = at.slope_of_r() * dkappa;
    const Long3 w1 = at.u2 - at.kappa * at.u1, w2 = at.kappa * at.u2 - at.u1;
    const Long3 dw1 = du2 - dkappa * at.u1 - at.kappa * du1, dw2 = dkappa * at.u2 + at.kappa * du2 - du1;
    subtract(i,
             {-at.k / at.l1 * (dr * w1 + r * dw1 - r * dl1 / at.l1 * w1),
              at.k / at.l2 * (dr * w2 + r * dw2 - r * dl2 / at.l2 * w2)},
             df);
  });
}

void add_bend_product_spd(const Strand& strand, Input x, Input dx, Output df) {
  each_joint(strand, x, [&](int i, const Joint& at) {
    if (!at.acts()) return;
    // Of a bend that is hardly there any axis is as good.
    Long3 b = at.u1.cross(at.u2);
    if (at.sine < 1e-15L) b = at.u1.unitOrthogonal();
    for (int again = 0; again < 2; ++again) b = (b - at.u1.dot(b) * at.u1).normalized();
    const Long3 g1 = -b.cross(at.u1) / at.l1, g2 = b.cross(at.u2) / at.l2;
    const auto [de1, de2] = changes(dx, i);
    const Real bending = g1.dot(de1) + g2.dot(de2), out = b.dot(de2) / at.l2 - b.dot(de1) / at.l1;
    const Real turning = std::max(at.r() * at.kappa, Real{0}) * out;
    subtract(i, {at.k * (bending * g1 - turning / at.l1 * b), at.k * (bending * g2 + turning / at.l2 * b)},
             df);
  });
}

}  // namespace hair
