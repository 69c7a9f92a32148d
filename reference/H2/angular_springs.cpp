// STAFF ONLY. H2: angular springs.
//
// Everything is written in w = phi b = phi / sin(phi) u1 x u2, which is smooth at phi = 0:
//
//   dE/de1 = -k w x u1 / |e1|,   dE/de2 = k w x u2 / |e2|,   E = k |w|^2 / 2.

#include "hair/angular_springs.h"

#include <algorithm>
#include <cmath>

namespace hair {
namespace {

using particles::Vector3d;

// A segment, as one of the two arms of its joint.
struct Arm {
  double length, per_length = 0;
  Vector3d direction = Vector3d::Zero();  // stays 0 for a segment of length 0

  explicit Arm(const Vector3d& e) : length(e.norm()) {
    if (length == 0) return;
    per_length = 1 / length;
    direction = e * per_length;
  }

  Vector3d turn(const Vector3d& de) const {  // the change of the direction with that of e
    return (de - direction * direction.dot(de)) * per_length;
  }
};

struct Joint {
  Joint(double stiffness, const Arm& above, const Arm& below) : k(stiffness), arm1(above), arm2(below) {
    if (arm1.length == 0 || arm2.length == 0) return;
    u1_x_u2 = arm1.direction.cross(arm2.direction);
    sine = u1_x_u2.norm();
    cosine = arm1.direction.dot(arm2.direction);
    folded = sine == 0 && cosine < 0;
    phi = cosine > 0.9 ? std::asin(sine) : std::atan2(sine, cosine);  // asin takes a third of the time
    if (sine > 0) q = phi / sine;                                     // 1 at phi = 0
    w = q * u1_x_u2;
  }

  bool rigid() const { return arm1.length == 0 || arm2.length == 0 || folded; }  // no force, no products
  // phi cot(phi).
  double p() const { return q * cosine; }

  // The axis of the bend. Next to phi = 0 u1 x u2 is a rounding error, and points anywhere, but b must always
  // be perpendicular to the strand.
  Vector3d axis() const {
    const Vector3d along = arm1.direction + arm2.direction;
    const Vector3d across = u1_x_u2 - along * (along.dot(u1_x_u2) / along.squaredNorm());
    const double size = across.norm();
    return size > 0 ? Vector3d(across * (1 / size)) : along.unitOrthogonal();
  }

  Vector3d de1() const { return -k * arm1.per_length * w.cross(arm1.direction); }  // dE/de1
  Vector3d de2() const { return k * arm2.per_length * w.cross(arm2.direction); }   // dE/de2

  double k;
  const Arm &arm1, &arm2;
  Vector3d u1_x_u2 = Vector3d::Zero(), w = Vector3d::Zero();
  double sine = 0, cosine = 1, phi = 0, q = 1;
  bool folded = false;
};

// Two vectors, one for each segment of a joint: their vectors, their changes, or the energy's derivatives.
struct Pair {
  Vector3d first, second;
};

// Calls visit(i, joint) for joint i, at the particles i - 1, i and i + 1; joint 0, of a clamped strand, is at
// 0 and 1.
template <typename Visit>
void for_each_joint(const Strand& strand, Input x, Visit visit) {
  Arm above(strand.root_tangent);
  for (int i = 0; i < strand.segments(); ++i) {
    const Arm below(x.segment<3>(3 * i + 3) - x.segment<3>(3 * i));
    const double l = (i > 0 ? strand.rest_length[i - 1] + strand.rest_length[i] : strand.rest_length[0]) / 2;
    if (i > 0 || strand.clamped) visit(i, Joint(strand.bend_rigidity / l, above, below));
    above = below;
  }
}

// The change of the two vectors of joint i along dx.
inline Pair change(int i, Input dx) {
  Pair de = {Vector3d::Zero(), dx.segment<3>(3 * i + 3) - dx.segment<3>(3 * i)};
  if (i > 0) de.first = dx.segment<3>(3 * i) - dx.segment<3>(3 * i - 3);
  return de;
}

// Subtracts from f the derivative by x of a function with the derivatives `by` by the vectors of joint i.
inline void subtract(int i, const Pair& by, Output f) {
  f.segment<3>(3 * i) += by.second;
  f.segment<3>(3 * i + 3) -= by.second;
  if (i == 0) return;
  f.segment<3>(3 * i - 3) += by.first;
  f.segment<3>(3 * i) -= by.first;
}

}  // namespace

double bend_energy(const Strand& strand, Input x) {
  double energy = 0;
  for_each_joint(strand, x, [&](int, const Joint& joint) { energy += joint.k * joint.phi * joint.phi / 2; });
  return energy;
}

void add_bend_force(const Strand& strand, Input x, Output f) {
  for_each_joint(strand, x, [&](int i, const Joint& joint) {
    if (!joint.rigid()) subtract(i, {joint.de1(), joint.de2()}, f);
  });
}

void add_bend_product(const Strand& strand, Input x, Input dx, Output df) {
  for_each_joint(strand, x, [&](int i, const Joint& joint) {
    if (joint.rigid()) return;
    const Pair de = change(i, dx);
    const Arm &arm1 = joint.arm1, &arm2 = joint.arm2;
    const Vector3d &u1 = arm1.direction, &u2 = arm2.direction;
    const Vector3d du1 = arm1.turn(de.first), du2 = arm2.turn(de.second);

    // w = q u1 x u2 with q = phi / sin(phi), and dq = (1 - phi cot(phi)) / sin(phi) dphi.
    Vector3d dw = du1.cross(u2) + u1.cross(du2);
    if (joint.sine > 0) {
      const Vector3d b = joint.u1_x_u2 / joint.sine;
      const double dphi = b.cross(u2).dot(du2) - b.cross(u1).dot(du1);
      dw = dw * joint.q + b * ((1 - joint.p()) * dphi);
    }
    auto second_derivative = [&](const Arm& arm, const Vector3d& du,
                                 const Vector3d& change_of_e) -> Vector3d {
      const Vector3d turned = dw.cross(arm.direction) + joint.w.cross(du);
      const double longer = arm.direction.dot(change_of_e) * arm.per_length;
      return joint.k * arm.per_length * (turned - longer * joint.w.cross(arm.direction));
    };
    subtract(i, {-second_derivative(arm1, du1, de.first), second_derivative(arm2, du2, de.second)}, df);
  });
}

void add_bend_product_spd(const Strand& strand, Input x, Input dx, Output df) {
  for_each_joint(strand, x, [&](int i, const Joint& joint) {
    if (joint.rigid()) return;
    const Pair de = change(i, dx);
    const double l1 = joint.arm1.per_length, l2 = joint.arm2.per_length;
    const Vector3d b = joint.axis();
    const Pair phi = {-l1 * b.cross(joint.arm1.direction), l2 * b.cross(joint.arm2.direction)};  // dphi/de
    const Pair g = {-l1 * b, l2 * b};
    const double bend = joint.k * (phi.first.dot(de.first) + phi.second.dot(de.second));
    const double turn =
        joint.k * std::max(joint.p(), 0.0) * (g.first.dot(de.first) + g.second.dot(de.second));
    subtract(i, {phi.first * bend + g.first * turn, phi.second * bend + g.second * turn}, df);
  });
}

}  // namespace hair
