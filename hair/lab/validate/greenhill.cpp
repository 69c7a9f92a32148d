#include "hair/lab/validate/greenhill.h"

#include <Eigen/Core>
#include <cmath>

#include "hair/lab/validate/clamped_hair.h"
#include "hair/lab/validate/planar_statics.h"
#include "solver/symmetric_eigen.h"

namespace hair {

namespace {

struct Lean {
  double angle, by_gamma, slope;  // theta(1), its derivative by Gamma, theta'(1)
};

Lean lean(double gamma) {
  Lean sum{1, 0, 0};
  double term = 1;
  for (int k = 1; k < 40; ++k) {
    term *= -gamma / ((3 * k - 1) * 3 * k);
    sum.angle += term;
    sum.by_gamma += k * term / gamma;
    sum.slope += 3 * k * term;
  }
  return sum;
}

}  // namespace

double greenhill_number() {
  double gamma = 8;
  for (int i = 0; i < 20; ++i) {
    const Lean at = lean(gamma);
    gamma -= at.angle / at.by_gamma;
  }
  return gamma;
}

double greenhill_error() {
  const double gamma = greenhill_number(), slope = lean(gamma).slope;
  return gamma * (1.0 / 20 + 3 / (40 * slope * slope));
}

double strand_greenhill(int segments) {
  return greenhill_number() * (1 - greenhill_error() / (segments * segments));
}

StrandStart standing_hair(const Material& material, int segments, double length) {
  StrandStart start = clamped_hair(material, segments, length, Vector3d::UnitZ());
  const Strand& strand = start.strand;
  double weight = kEarthGravity * strand.mass.sum();
  for (int i = 0; i < segments; ++i) {
    weight -= kEarthGravity * strand.mass[i];
    start.state.x[3 * i + 5] =
        start.state.x[3 * i + 2] + strand.rest_length[i] * (1 - weight / strand.stretch_rigidity);
  }
  return start;
}

double softest_stiffness(const StrandStart& standing) {
  const auto strand = under_gravity(standing, Vector3d(0, 0, -kEarthGravity));
  const Eigen::MatrixXd K = planar_stiffness(strand->force, standing.state.x);
  const int n = standing.strand.segments();
  // Each particle has two unknowns; this takes the horizontal one.
  const Eigen::MatrixXd sideways = K(Eigen::seqN(0, n, 2), Eigen::seqN(0, n, 2));
  return solver::symmetric_eigenvalues(sideways)[0];
}

}  // namespace hair
