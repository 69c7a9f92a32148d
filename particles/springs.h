// Damped springs between pairs of particles. With d = x_i - x_j, l = |d|, u = d / l, and w the relative
// velocity v_i - v_j, a spring has
//
//   E = k (l - l0)^2 / 2,   f_i = -(k (l - l0) + c w . u) u = -f_j.
//
// The damping c acts only along the spring, so rotation is not damped. A spring of length 0 has no direction:
// its force and its derivatives are 0.
//
// With Products::definite, the products with df/dx leave out the geometric term k (1 - l0/l) (I - u u^T) in
// compression, and always leave out the damping's part. Source: D. Baraff and A. Witkin, "Large Steps in
// Cloth Simulation" (SIGGRAPH 1998), section 4.
#pragma once

#include <vector>

#include "particles/force.h"

namespace particles {

// The matrix of a force's products with df/dx: the exact derivative, or one that suits an implicit step.
enum class Products {
  exact,    // the exact df/dx. It may have positive eigenvalues, and with damping it is not symmetric
  definite  // df/dx without those parts: symmetric and negative semi-definite, so that ConjGrad can solve
};

struct Spring {
  int i, j;            // i != j
  double stiffness;    // k, N/m, >= 0
  double rest_length;  // l0, m, >= 0
  double damping = 0;  // c, N s/m, >= 0
};

class DampedSprings : public Force {
 public:
  // Throws std::invalid_argument for values outside of their bounds.
  explicit DampedSprings(std::vector<Spring> springs, Products products = Products::exact);

  double energy(Input x) const override;
  void add_force(Input x, Input v, Output f) const override;
  void add_dfdx(Input x, Input v, Input dx, Output df) const override;
  void add_dfdv(Input x, Input v, Input dv, Output df) const override;

 private:
  std::vector<Spring> springs_;
  Products products_;
};

}  // namespace particles
