// Penalty contact: obstacles that push out particles that have entered them. Let p be the depth of a particle
// below the surface and N the surface's normal there, pointing out of the obstacle. A particle with p > 0 has
//
//   E = k p^2 / 2,   f = max(k p - c v . N, 0) N,
//
// and a particle with p <= 0 has neither energy nor force. So damping acts only in contact, and never pulls
// back a particle that leaves faster than the penalty pushes it. The force jumps by -c v . N where contact
// begins; without damping it is continuous. There is no friction.
//
// Where max(...) is 0, the products with df/dx and df/dv are 0 too.
#pragma once

#include "particles/force.h"
#include "particles/products.h"

namespace particles {

// The half-space below the plane through `point` with the normal `normal`.
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

// The ball inside a sphere. At its very centre the normal is (0, 0, 1) and its derivative is taken as 0.
//
// A particle that is pressed against a ball is also pushed sideways once it has moved sideways: df/dx has
// positive eigenvalues, and damping makes it unsymmetric. Products::definite leaves out the derivative of the
// normal.
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
