// A tree of links with all its forces: the accelerations of its joints, for explicit and linearly implicit
// steps.
//
// A linearly implicit step of h seconds takes the forces that grow with q and q' at its end:
//
//   Q(q + h q' + h^2 q", q' + h q") = Q(q, q') - h K q' - (h^2 K + h C) q"       K = -dQ/dq, C = -dQ/dq'
//
// The last term goes to the left, where it stiffens the joint: `stiffening` = h^2 K + h C adds to s^'I^A s^.
// Forces at links do the same to the link's inertia: drag c adds h c, a force with the stiffness S at a point
// adds h^2 S. So the recursion stays as it is, and linear.
//
// A joint feels a limit if it is beyond it at the end of the step, which is unknown before: the step is
// repeated with the limits that it met, and without those that would pull, until this set and the joints'
// directions stay the same. A set that does not settle in ten attempts may only grow from then on: a limit
// that pulls for one step takes energy, and a set that is cut off makes some. Source of the method: D. Baraff
// and A. Witkin, "Large Steps in Cloth Simulation" (SIGGRAPH 1998), section 3, there for particles.
//
// A spherical limit's energy k (|theta| - u)^2 / 2 has the second derivative k n n^T + N / |theta| (1 - n
// n^T), n along theta, N the limit's torque. Both parts are implicit: twist has so little inertia that each
// step would multiply it by N l / (|theta| GJ) if the part across n were explicit, with any h.
//
// Weight and the terms of velocities are explicit, unless the links are a strand that needs its momenta
// (hair/rigid_links/link_momenta.h): for these, an explicit step has two bounds.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "hair/rigid_links/link_momenta.h"
#include "hair/rigid_links/tree_motion.h"
#include "hair/strand/turns.h"

namespace hair {

// A spring and a damper at a joint. The energy of a spherical joint that is turned by the vector theta (rad,
// at most pi long) against its rest is
//
//   E = theta^T K theta / 2      theta = 2 atan2(|v|, w) v / |v|  of its quaternion, w + v, with w >= 0
//
// theta has the same components along the axes at rest (q = 0) and along the turned ones: the spring treats
// its two links alike. As w, the angular velocity between the links, turns the joint,
//
//   theta' = A w,   A = 1 - theta~ / 2 + g theta~^2,   g = (1 - |theta| / 2 cot(|theta| / 2)) / |theta|^2
//
// (J. E. Bortz, "A New Mathematical Formulation for Strapdown Inertial Navigation", IEEE Transactions on
// Aerospace and Electronic Systems 7 (1971)), so its torque is -A^T K theta. At half a turn the torque
// changes its sign, because the opposite way back is shorter then.
//
// A revolute or prismatic joint uses only the number K[0, 0].
//
// A limit is a spring of its own, which acts only beyond it, like an elastic buffer. Its energy is
// limit_stiffness (|theta| - upper)^2 / 2 for |theta| > upper; for revolute and prismatic joints the same
// below `lower`.
struct JointSpring {
  Matrix3d stiffness =
      Matrix3d::Zero();                 // K, N m/rad or N/m, along the joint's axes at rest; symmetric, >= 0
  Matrix3d damping = Matrix3d::Zero();  // C, N m s/rad or N s/m: the same
  double lower = -std::numeric_limits<double>::infinity();  // rad or m; not for spherical joints
  double upper = std::numeric_limits<double>::infinity();   // rad or m
  double limit_stiffness = 0;                               // N m/rad or N/m, >= 0

  // The distance of a joint beyond its limits; negative below `lower`, 0 between them.
  double beyond(double place) const {
    return place > upper ? place - upper : place < lower ? place - lower : 0;
  }

  // J.
  double energy(double place) const {
    const double too_far = beyond(place);
    return (stiffness(0, 0) * place * place + limit_stiffness * too_far * too_far) / 2;
  }
  double energy(const Vector3d& theta) const {
    const double too_far = beyond(theta.norm());
    return (theta.dot(stiffness * theta) + limit_stiffness * too_far * too_far) / 2;
  }
};

// Constant forces. All are optional: a vector has one entry for each link, the base included, or none.
struct TreeForces {
  Vector3d gravity = Vector3d::Zero();  // m/s^2
  std::vector<JointSpring> springs;
  double drag = 0;                   // N s/m^2, per metre of the rods
  Vector3d wind = Vector3d::Zero();  // m/s, of the air
  std::vector<Vector3d>
      rods;  // m, from one end to the other, the centre of mass between them; along the link's axes
  std::optional<double> bend_rigidity = {};  // N m^2, of a strand of rods: its steps may keep momenta
};

// A force at a point of a link, with its derivative by this point's position and velocity: f - S dx - C dv.
struct LinkForce {
  int link;
  Vector3d arm;        // m, from the link's centre of mass to the point, along the link's axes
  Vector3d force;      // N
  Matrix3d stiffness;  // S, N/m, symmetric, >= 0
  Matrix3d damping;    // C, N s/m, symmetric, >= 0
};

class TreeSystem {
 public:
  TreeSystem(const LinkTree& tree, TreeForces forces);

  const LinkTree& tree() const { return motion_.tree(); }
  const TreeMotion& motion() const { return motion_; }  // result of the last accelerations()
  TreeMotion& motion() { return motion_; }

  // Places the links, and calculates their accelerations; explicit if h = 0. Allocates nothing.
  void accelerations(const TreeBase& base, Input q, Input rates, double h, std::span<const LinkForce> more,
                     Output result);

  // A caller says when a step is done: momenta().next().
  LinkMomenta& momenta() { return momenta_; }
  const LinkMomenta& momenta() const { return momenta_; }

  // J, for `motion`'s velocities and q: of movement, of weight and of springs.
  double kinetic_energy() const;
  double potential_energy(Input q) const;

 private:
  // A limit that acts: the joint's coordinate along `along` is above or below a bound.
  struct Limit {
    bool acts = false;
    double bound = 0;                   // rad or m
    Vector3d along = Vector3d::Zero();  // a direction for a spherical joint's theta; else [+-1, 0, 0]
    double beyond = 0;                  // rad, for spherical joints: after the step, as last found
  };

  void settle(const TreeBase& base, Input q, Input rates, double h, std::span<const LinkForce> more,
              Output result);
  void attempt(const TreeBase& base, Input q, Input rates, double h, std::span<const LinkForce> more,
               Output result);
  void add_springs(Input q, Input rates, double h);
  void add_limit(int joint, Input rates, double h, const Vector3d& place, const Matrix3d& A);
  // Checks positions after h seconds with these rates and accelerations. Returns false if no limit changed.
  // may_end: limits that would pull end.
  bool change_limits(Input q, Input rates, Input accelerations, double h, bool may_end);

  void add_drag(double h);
  void add_force(const LinkForce& one, double h);

  TreeMotion motion_;
  TreeForces forces_;
  LinkMomenta momenta_;
  std::vector<Limit> limits_;  // for each link's joint; empty: no joint has a limit
  Eigen::VectorXd Q_;
};

}  // namespace hair
