// STAFF ONLY. A right solution of H2 in the cosine c = u1 . u2, with phi = 2 atan2(|u1 - u2|, |u1 + u2|):
//
//   grad phi = -grad c / s,   d2phi = -d2c / s - (c / s^3) grad c grad c^T.
//
// It divides by the sine more often than other formulas, and so rounds most. A nearly straight joint has
// products of its own.

#include "hair/angular_springs.h"

#include <algorithm>
#include <cmath>

using Eigen::Vector3d;
using hair::Strand;

namespace {

struct Joint {
  double k = 0, l1 = 0, l2 = 0, s = 0, c = 1, phi = 0;
  Vector3d u1 = Vector3d::Zero(), u2 = Vector3d::Zero();

  Joint(double stiffness, const Vector3d& e1, const Vector3d& e2)
      : k(stiffness), l1(std::sqrt(e1.dot(e1))), l2(std::sqrt(e2.dot(e2))) {
    if (l1 == 0 || l2 == 0) return;
    u1 = e1 / l1;
    u2 = e2 / l2;
    s = u1.cross(u2).norm();
    c = u1.dot(u2);
    phi = 2 * std::atan2((u1 - u2).norm(), (u1 + u2).norm());
  }

  bool nothing() const { return l1 == 0 || l2 == 0 || (s == 0 && c < 0); }
  bool straight() const { return s < 1e-7 && c > 0; }
  // dc/de1 and dc/de2.
  Vector3d dc1() const { return (u2 - c * u1) / l1; }
  Vector3d dc2() const { return (u1 - c * u2) / l2; }
};

// Calls visit(i, joint) from the tip to the root.
template <typename Visit>
void for_each(const Strand& strand, particles::Input x, Visit visit) {
  const auto segment = [&](int i) -> Vector3d { return x.segment<3>(3 * i + 3) - x.segment<3>(3 * i); };
  for (int i = strand.segments() - 1; i > 0; --i)
    visit(i, Joint(2 * strand.bend_rigidity / (strand.rest_length[i - 1] + strand.rest_length[i]),
                   segment(i - 1), segment(i)));
  if (strand.clamped && strand.segments() > 0)
    visit(0, Joint(strand.bend_rigidity / (strand.rest_length[0] / 2), strand.root_tangent, segment(0)));
}

// Subtracts from f the derivative by the particles of a function with the derivatives d1 and d2 by e1 and e2.
void subtract(int i, const Vector3d& d1, const Vector3d& d2, particles::Output f) {
  f.segment<3>(3 * i + 3) -= d2;
  f.segment<3>(3 * i) += d2;
  if (i == 0) return;
  f.segment<3>(3 * i) -= d1;
  f.segment<3>(3 * i - 3) += d1;
}

struct Change {
  Vector3d first, second;
};

Change change(int i, particles::Input dx) {
  const Vector3d second = dx.segment<3>(3 * i + 3) - dx.segment<3>(3 * i);
  if (i == 0) return {Vector3d::Zero(), second};
  return {dx.segment<3>(3 * i) - dx.segment<3>(3 * i - 3), second};
}

// Both products of a straight joint, whose bend is across the strand: (I - u u^T) (de2 / l2 - de1 / l1).
void subtract_straight(int i, const Joint& joint, const Change& de, particles::Output df) {
  const Vector3d u = (joint.u1 + joint.u2) / 2, apart = de.second / joint.l2 - de.first / joint.l1;
  const Vector3d across = joint.k * (apart - u.dot(apart) * u);
  subtract(i, -across / joint.l1, across / joint.l2, df);
}

}  // namespace

double hair::bend_energy(const Strand& strand, Input x) {
  double E = 0;
  for_each(strand, x, [&](int, const Joint& joint) { E += joint.phi * (joint.k * joint.phi); });
  return E / 2;
}

void hair::add_bend_force(const Strand& strand, Input x, Output f) {
  for_each(strand, x, [&](int i, const Joint& joint) {
    if (joint.nothing() || joint.s == 0) return;
    const double by = -joint.k * joint.phi / joint.s;
    subtract(i, by * joint.dc1(), by * joint.dc2(), f);
  });
}

void hair::add_bend_product(const Strand& strand, Input x, Input dx, Output df) {
  for_each(strand, x, [&](int i, const Joint& joint) {
    if (joint.nothing()) return;
    const Change de = change(i, dx);
    if (joint.straight()) return subtract_straight(i, joint, de, df);
    const Vector3d a = joint.dc1(), b = joint.dc2();
    const double dc = a.dot(de.first) + b.dot(de.second);
    const Vector3d du1 = (de.first - joint.u1.dot(de.first) * joint.u1) / joint.l1,
                   du2 = (de.second - joint.u2.dot(de.second) * joint.u2) / joint.l2;
    // The changes of a and b: d2c times de.
    const Vector3d da =
        (du2 - dc * joint.u1 - joint.c * du1) / joint.l1 - joint.u1.dot(de.first) / joint.l1 * a;
    const Vector3d db =
        (du1 - dc * joint.u2 - joint.c * du2) / joint.l2 - joint.u2.dot(de.second) / joint.l2 * b;
    const double s = joint.s, by_c = -joint.k * joint.phi / s,
                 by_dc = joint.k * (1 / (s * s) - joint.phi * joint.c / (s * s * s)) * dc;
    subtract(i, by_c * da + by_dc * a, by_c * db + by_dc * b, df);
  });
}

void hair::add_bend_product_spd(const Strand& strand, Input x, Input dx, Output df) {
  for_each(strand, x, [&](int i, const Joint& joint) {
    if (joint.nothing()) return;
    const Change de = change(i, dx);
    if (joint.straight()) return subtract_straight(i, joint, de, df);
    const Vector3d a = joint.dc1(), b = joint.dc2(), axis = joint.u1.cross(joint.u2) / joint.s;
    const double s = joint.s, dphi = joint.k / (s * s) * (a.dot(de.first) + b.dot(de.second));
    const double turn = joint.k * std::max(joint.phi * joint.c / s, 0.0) *
                        axis.dot(de.second / joint.l2 - de.first / joint.l1);
    subtract(i, dphi * a - turn / joint.l1 * axis, dphi * b + turn / joint.l2 * axis, df);
  });
}
