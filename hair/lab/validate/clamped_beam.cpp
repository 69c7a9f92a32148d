#include "hair/lab/validate/clamped_beam.h"

#include <Eigen/Core>
#include <cmath>
#include <numbers>

#include "hair/lab/validate/clamped_hair.h"
#include "hair/lab/validate/planar_statics.h"
#include "solver/symmetric_eigen.h"

namespace hair {

// Newton's method on cos(b) + 1 / cosh(b), which does not overflow, from a zero of the cosine.
double clamped_beam_root(int mode) {
  double b = (mode - 0.5) * std::numbers::pi;
  for (int i = 0; i < 20; ++i)
    b += (std::cos(b) + 1 / std::cosh(b)) / (std::sin(b) + std::tanh(b) / std::cosh(b));
  return b;
}

double clamped_beam_error(int mode) {
  const double b = clamped_beam_root(mode);
  const double Sb = b * (std::cos(b) + std::cosh(b)) / (std::sin(b) + std::sinh(b));
  return Sb * (6 + Sb) / 6;
}

BeamModes beam_modes(const StrandStart& start) {
  const auto strand = under_gravity(start, Vector3d::Zero());
  const Eigen::MatrixXd K = planar_stiffness(strand->force, start.state.x);
  const int n = start.strand.segments();
  const Eigen::VectorXd weights = start.strand.mass.tail(n).cwiseSqrt().cwiseInverse();
  // Each particle has two unknowns; this takes the vertical one.
  const Eigen::MatrixXd sideways = K(Eigen::seqN(1, n, 2), Eigen::seqN(1, n, 2));
  const solver::SymmetricEigen eigen =
      solver::symmetric_eigen(weights.asDiagonal() * sideways * weights.asDiagonal());
  return {eigen.values.cwiseSqrt(), weights.asDiagonal() * eigen.vectors};
}

double beam_root_of(const Material& material, double length, double frequency) {
  return std::sqrt(frequency * length * length *
                   std::sqrt(material.line_density() / material.bend_rigidity()));
}

}  // namespace hair
