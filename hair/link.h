// A link of a chain or tree as it lies now, and the results of H7's passes. Links are numbered as in the
// lecture: link 0 is the base, whose motion is given; links 1 to n follow, parents before their children.
//
//   parent's c.o.m.                  joint i                    c.o.m. of link i
//        o ----------------------------(o)------------------------------ o
//                                       |-------------- d -------------->|
//        |------------------------------- r ---------------------------->|
//
// All vectors are along the axes of the world; see hair/spatial.h.
#pragma once

#include "hair/spatial.h"

namespace hair {

// The motion of a link relative to its parent. The spatial joint axis s^ is this motion at the rate 1.
enum class JointType {
  revolute,   // turn about the axis u: s^ = [u; u x d], the rate in rad/s
  prismatic,  // slide along u:         s^ = [0; u], the rate in m/s
  spherical  // turn about any axis:   s^ = [w; w x d] for each w. Its three rates are the angular velocity of
             // the link relative to its parent, along the axes of the world, rad/s
};

// The number of a joint's rates, of its forces Q and of its accelerations.
inline int rates_of(JointType type) {
  return type == JointType::spherical ? 3 : 1;
}

struct Link {
  int parent = 0;  // less than the link's own number
  JointType joint = JointType::revolute;
  int first = 0;  // the joint's rates are [first], or first to first + 2, among all rates

  Vector3d u = Vector3d::Zero();  // length 1; unused for spherical joints
  Vector3d d = Vector3d::Zero();  // m, from the joint to the centre of mass; 0 for prismatic joints
  Vector3d r = Vector3d::Zero();  // m, from the parent's centre of mass to the link's own

  Matrix3d tensor = Matrix3d::Zero();  // I, kg m^2, of the link alone, about its centre of mass
  SpatialForce external;               // on the link: weight, drag, contacts

  // I^: [0 m; I 0]. Implicit steps add to it, because forces that grow during the step resist accelerations.
  SpatialInertia inertia;

  // Implicit steps add this to a joint's s^'I^s^, for the same reason: the spring at the joint resists. kg
  // m^2 (revolute: [0, 0], spherical: symmetric, positive semi-definite) or kg (prismatic: [0, 0]). Otherwise
  // 0.
  Matrix3d stiffening = Matrix3d::Zero();
};

// Results of the three passes for one link. The caller sets v and a of the base.
struct LinkPass {
  SpatialMotion v;         // v^, its velocity
  SpatialMotion c;         // c^, the part of its acceleration that comes from velocities alone
  SpatialForce bias;       // Z^, then Z^A
  SpatialInertia inertia;  // I^A
  Matrix3d gain =
      Matrix3d::Zero();  // (s^'I^A s^ + stiffening)^-1, which (4.27) to (4.29) need; [0, 0] if it is a number
  SpatialMotion a;       // a^, its acceleration
};

}  // namespace hair
