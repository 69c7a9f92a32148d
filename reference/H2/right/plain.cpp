// STAFF ONLY. A right solution of H2, in the angle and its axis.

#include "hair/angular_springs.h"

#include <algorithm>
#include <cmath>

using Eigen::Vector3d;
using hair::Strand;

namespace {

// The joint between the segments e1 and e2.
struct Bend {
  bool nothing;        // no force and no products
  double l1, l2, k;    // lengths, stiffness
  double phi, ratio;   // the angle, phi / sin(phi)
  double cot;          // phi cot(phi)
  Vector3d u1, u2, b;  // directions, axis
  Vector3d g1, g2;     // dphi/de1, dphi/de2
};

Bend bend_of(const Vector3d& e1, const Vector3d& e2, double k) {
  Bend bend;
  bend.k = k;
  bend.phi = 0;
  bend.nothing = true;
  bend.l1 = e1.norm();
  bend.l2 = e2.norm();
  if (bend.l1 == 0 || bend.l2 == 0) return bend;
  bend.u1 = e1 / bend.l1;
  bend.u2 = e2 / bend.l2;
  Vector3d c = bend.u1.cross(bend.u2);
  double s = c.norm();
  double dot = bend.u1.dot(bend.u2);
  bend.phi = std::atan2(s, dot);
  if (s < 1e-8 && dot > 0) {
    // The joint is nearly straight, so any axis will do.
    bend.b = bend.u1.unitOrthogonal();
    bend.ratio = 1;
    bend.cot = 1;
    // Even a small bend has a direction.
    if (s > 0) bend.b = (c - bend.u1 * bend.u1.dot(c)).normalized();
    if (!(bend.b.norm() > 0.5)) bend.b = bend.u1.unitOrthogonal();
  } else if (s == 0) {
    return bend;  // folded
  } else {
    bend.b = c / s;
    bend.ratio = bend.phi / s;
    bend.cot = bend.phi * dot / s;
  }
  bend.nothing = false;
  bend.g1 = -bend.b.cross(bend.u1) / bend.l1;
  bend.g2 = bend.b.cross(bend.u2) / bend.l2;
  return bend;
}

int first_joint(const Strand& strand) {
  return strand.clamped ? 0 : 1;
}

Vector3d segment(const Strand&, particles::Input x, int i) {
  return x.segment<3>(3 * (i + 1)) - x.segment<3>(3 * i);
}

Bend joint(const Strand& strand, particles::Input x, int i) {
  if (i == 0)
    return bend_of(strand.root_tangent, segment(strand, x, 0),
                   2 * strand.bend_rigidity / strand.rest_length(0));
  double l = 0.5 * (strand.rest_length(i - 1) + strand.rest_length(i));
  return bend_of(segment(strand, x, i - 1), segment(strand, x, i), strand.bend_rigidity / l);
}

// The gradient in x has -d1, d1 - d2, d2 for the three particles; forces are minus that.
void add_to_particles(int i, const Vector3d& d1, const Vector3d& d2, particles::Output f) {
  if (i > 0) f.segment<3>(3 * (i - 1)) += d1;
  if (i > 0) f.segment<3>(3 * i) -= d1;
  f.segment<3>(3 * i) += d2;
  f.segment<3>(3 * (i + 1)) -= d2;
}

}  // namespace

double hair::bend_energy(const Strand& strand, Input x) {
  double E = 0;
  for (int i = first_joint(strand); i < strand.segments(); i++) {
    Bend bend = joint(strand, x, i);
    E += 0.5 * bend.k * bend.phi * bend.phi;
  }
  return E;
}

void hair::add_bend_force(const Strand& strand, Input x, Output f) {
  for (int i = first_joint(strand); i < strand.segments(); i++) {
    Bend bend = joint(strand, x, i);
    if (bend.nothing) continue;
    add_to_particles(i, bend.k * bend.phi * bend.g1, bend.k * bend.phi * bend.g2, f);
  }
}

void hair::add_bend_product(const Strand& strand, Input x, Input dx, Output df) {
  for (int i = first_joint(strand); i < strand.segments(); i++) {
    Bend bend = joint(strand, x, i);
    if (bend.nothing) continue;
    Vector3d de1 = Vector3d::Zero();
    if (i > 0) de1 = dx.segment<3>(3 * i) - dx.segment<3>(3 * (i - 1));
    Vector3d de2 = dx.segment<3>(3 * (i + 1)) - dx.segment<3>(3 * i);
    Vector3d du1 = (de1 - bend.u1 * bend.u1.dot(de1)) / bend.l1;
    Vector3d du2 = (de2 - bend.u2 * bend.u2.dot(de2)) / bend.l2;
    double dphi = bend.g1.dot(de1) + bend.g2.dot(de2);
    // phi times the change of the axis.
    Vector3d dc = du1.cross(bend.u2) + bend.u1.cross(du2);
    Vector3d phi_db = bend.ratio * (dc - bend.b * bend.b.dot(dc));
    // phi times the changes of g1 and g2.
    Vector3d phi_dg1 = -(phi_db.cross(bend.u1) + bend.phi * bend.b.cross(du1)) / bend.l1 -
                       bend.phi * bend.g1 * bend.u1.dot(de1) / bend.l1;
    Vector3d phi_dg2 = (phi_db.cross(bend.u2) + bend.phi * bend.b.cross(du2)) / bend.l2 -
                       bend.phi * bend.g2 * bend.u2.dot(de2) / bend.l2;
    add_to_particles(i, bend.k * (bend.g1 * dphi + phi_dg1), bend.k * (bend.g2 * dphi + phi_dg2), df);
  }
}

void hair::add_bend_product_spd(const Strand& strand, Input x, Input dx, Output df) {
  for (int i = first_joint(strand); i < strand.segments(); i++) {
    Bend bend = joint(strand, x, i);
    if (bend.nothing) continue;
    Vector3d de1 = Vector3d::Zero();
    if (i > 0) de1 = dx.segment<3>(3 * i) - dx.segment<3>(3 * (i - 1));
    Vector3d de2 = dx.segment<3>(3 * (i + 1)) - dx.segment<3>(3 * i);
    double dphi = bend.g1.dot(de1) + bend.g2.dot(de2);
    double out = bend.b.dot(de2 / bend.l2 - de1 / bend.l1);
    double p = std::max(bend.cot, 0.0);
    Vector3d d1 = bend.k * (bend.g1 * dphi - p * out * bend.b / bend.l1);
    Vector3d d2 = bend.k * (bend.g2 * dphi + p * out * bend.b / bend.l2);
    add_to_particles(i, d1, d2, df);
  }
}
