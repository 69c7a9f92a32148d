// Penalty contact: obstacles that push out what has entered them. With p the depth of a particle below the
// surface, N the surface's normal there, out of the obstacle, a particle with p > 0 has
//
//   E = k p^2 / 2,   f = max(k p - c v . N, 0) N,
//
// and one with p <= 0 nothing. So damping acts in contact alone, and never pulls a particle back that leaves
// faster than the penalty pushes it. The force jumps by -c v . N where contact begins; without damping it is
// continuous. There is no friction.
//
// Where max(...) is 0, products are 0 as well.
#pragma once

#include "particles/force.h"
#include "particles/products.h"

namespace particles {

// All that is below the plane through `point` whose normal is `normal`.
class PlaneContact : public Force {
 public:
  // normal: any length but 0. stiffness k, N/m, damping c, N s/m: >= 0. Throws std::invalid_argument.
  PlaneContact(const Vector3d& point, const Vector3d& normal, double stiffness, double damping = 0);

  double energy(Input x) const override;
  void add_force(Input x, Input v, Output f) const override;
  void add_dfdx(Input x, Input v, Input dx, Output df) const override;
  void add_dfdv(Input x, Input v, Input dv, Output df) const override;

 private:
  Vector3d point_, normal_;
  double stiffness_, damping_;
};

// The ball inside of a sphere. At its very centre the normal is (0, 0, 1), and does not turn.
//
// Pressed to a ball a particle is pushed sideways, too, once it has moved sideways: df/dx has positive
// eigenvalues, and damping makes it unsymmetric. Products::definite leaves out that the normal turns.
class SphereContact : public Force {
 public:
  // radius: m, > 0; otherwise as above.
  SphereContact(const Vector3d& centre, double radius, double stiffness, double damping = 0,
                Products products = Products::exact);

  double energy(Input x) const override;
  void add_force(Input x, Input v, Output f) const override;
  void add_dfdx(Input x, Input v, Input dx, Output df) const override;
  void add_dfdv(Input x, Input v, Input dv, Output df) const override;

 private:
  Vector3d centre_;
  double radius_, stiffness_, damping_;
  Products products_;
};

}  // namespace particles
