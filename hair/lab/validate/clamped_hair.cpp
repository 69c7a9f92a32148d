#include "hair/lab/validate/clamped_hair.h"

#include <cmath>
#include <numbers>

#include "hair/lab/validate/planar_statics.h"
#include "hair/mass_spring/force_parts.h"
#include "hair/strand/make_strand.h"
#include "solver/dense_algebra.h"

namespace hair {

double length_of(const Material& material, double weight_over_stiffness) {
  return std::cbrt(weight_over_stiffness * material.bend_rigidity() /
                   (material.line_density() * kEarthGravity));
}

StrandStart clamped_hair(const Material& material, int segments, double length, const Vector3d& direction) {
  StrandStart start;
  start.strand = uniform_strand(material, segments, length);
  start.strand.clamped = true;
  start.strand.root_tangent = direction;
  start.state.x =
      straight_shape(segments, length, {Vector3d::Zero(), direction, direction.unitOrthogonal()}).x;
  start.state.v.setZero(start.state.x.size());
  return start;
}

std::unique_ptr<MovingStrand> under_gravity(const StrandStart& start, const Vector3d& gravity) {
  const ForceOptions options{GeometricTerm::full, Products::exact, gravity};
  auto moving = std::make_unique<MovingStrand>(start.strand, start.state);
  add_forces(options, start, *moving);
  return moving;
}

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
