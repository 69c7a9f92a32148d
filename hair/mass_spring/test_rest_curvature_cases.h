// STAFF ONLY. Shared code of the tests of hair/mass_spring/rest_curvature.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "hair/mass_spring/rest_curvature.h"
#include "hair/strand/test_strand_states.h"
#include "solver/dense_algebra.h"

namespace hair {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using reference_tests::kUnit;
using reference_tests::strand_states;
using reference_tests::StrandState;
using std::numbers::pi;

inline Vector3d some_normal(const Vector3d& tangent) {
  return tangent.cross(Vector3d(0.3, -0.2, 0.9)).normalized();
}

// Components of at most 0.5 radians, all different.
inline VectorXd some_rest(const Strand& strand) {
  VectorXd rest(2 * strand.segments());
  for (Eigen::Index i = 0; i < rest.size(); ++i)
    rest[i] = 0.5 * std::sin(1.7 * static_cast<double>(i * i) + 0.4);
  return rest;
}

inline VectorXd force_of(const particles::Force& force, const VectorXd& x) {
  VectorXd f = VectorXd::Zero(x.size());
  force.add_force(x, x, f);
  return f;
}

inline VectorXd product_of(const particles::Force& force, const VectorXd& x, const VectorXd& dx) {
  VectorXd df = VectorXd::Zero(x.size());
  force.add_dfdx(x, x, dx, df);
  return df;
}

inline MatrixXd matrix_of(const particles::Force& force, const VectorXd& x) {
  return reference_tests::matrix_of([&](const VectorXd& dx) { return product_of(force, x, dx); }, x.size());
}

inline VectorXd eigenvalues(const MatrixXd& matrix) {
  return solver::symmetric_eigenvalues((matrix + matrix.transpose()) / 2);
}

// The sizes of energies, forces and products: k pi, k pi / l and k pi / l^2, times the sum of frames along
// the strand.
struct Scales {
  explicit Scales(const StrandState& s)
      : energy(2 * s.strand.bend_rigidity / s.strand.rest_length.minCoeff() * pi * pi * s.strand.count()),
        force(energy / s.shortest / std::min(1.0, s.least_bend)),
        product(force / s.shortest / std::min(1.0, s.least_bend)) {}

  double energy, force, product;
};

inline std::vector<StrandState> clamped_states() {
  std::vector<StrandState> states;
  for (const StrandState& s : strand_states())
    if (s.strand.clamped) states.push_back(s);
  return states;
}

}  // namespace hair
