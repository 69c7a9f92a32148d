// A link of a chain or tree as it lies now, and what is calculated of it. Links are numbered as in the
// lecture: link 0 is the base, which moves as it is told; links 1 to n follow, parents before their children.
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

// What a joint lets its link do, beside its parent: the spatial joint axis s^ is the motion at the rate 1.
enum class JointType {
  revolute,   // turn about the axis u: s^ = [u; u x d], the rate in rad/s
  prismatic,  // slide along u:         s^ = [0; u], the rate in m/s
  spherical  // turn about any axis:   s^ = [w; w x d] for each w. Its three rates are the angular velocity of
             // the link beside its parent, along the axes of the world, rad/s
};

// The number of a joint's rates, of its forces Q and of its accelerations.
inline int rates_of(JointType type) {
  return type == JointType::spherical ? 3 : 1;
}

struct Link {
  int parent = 0;  // less than the link's own number
  JointType joint = JointType::revolute;
  int first = 0;  // where the joint's rates are among all rates: [first], or first to first + 2

  Vector3d u = Vector3d::Zero();  // of length 1; of spherical joints none
  Vector3d d = Vector3d::Zero();  // m, from the joint to the centre of mass; of prismatic joints 0
  Vector3d r = Vector3d::Zero();  // m, from the parent's centre of mass to the link's own

  Matrix3d tensor = Matrix3d::Zero();  // I, kg m^2, of the link alone, about its centre of mass
  SpatialForce external;               // on the link: weight, drag, contacts

  // I^: [0 m; I 0]. Implicit steps add to it what resists accelerations because forces grow with them.
  SpatialInertia inertia;

  // Implicit steps add this to a joint's s^'I^s^, for the same reason: the spring at the joint resists. kg
  // m^2 (revolute: [0, 0], spherical: symmetric, positive semi-definite) or kg (prismatic: [0, 0]). Otherwise
  // 0.
  Matrix3d stiffening = Matrix3d::Zero();
};

// What the passes find of a link. Of the base, the caller sets v and a.
struct LinkPass {
  SpatialMotion v;         // v^, its velocity
  SpatialMotion c;         // c^, its acceleration because it moves, beside that of its parent and its joint
  SpatialForce bias;       // Z^, then Z^A
  SpatialInertia inertia;  // I^A
  Matrix3d gain =
      Matrix3d::Zero();  // (s^'I^A s^ + stiffening)^-1, which (4.27) to (4.29) need; [0, 0] if it is a number
  SpatialMotion a;       // a^, its acceleration
};

}  // namespace hair
