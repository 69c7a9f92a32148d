// STAFF ONLY. H1 obeys physics and geometry. The public checks test the promises of hair/stretch_springs.h.

#include "hair/stretch_springs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "hair/strand/make_strand.h"
#include "hair/strand/test_strand_states.h"
#include "solver/symmetric_eigen.h"
#include "solver/test_allocations.h"

namespace reference_tests {
namespace {

using hair::GeometricTerm;
using std::numbers::pi;

VectorXd stretch_force(const Strand& strand, const VectorXd& x) {
  VectorXd result = VectorXd::Zero(x.size());
  add_stretch_force(strand, x, result);
  return result;
}

VectorXd stretch_product(const Strand& strand, const VectorXd& x, const VectorXd& dx, GeometricTerm term) {
  VectorXd result = VectorXd::Zero(x.size());
  add_stretch_product(strand, x, term, dx, result);
  return result;
}

// The largest k (1 + l0/l) of all springs, which bounds a product's entry.
double stiffest_stretch(const StrandState& s) {
  return 2 * s.strand.stretch_rigidity / s.strand.rest_length.minCoeff() * (1 + 1.5 / s.shortest);
}

TEST(StretchSprings, TurnWithARigidMotion) {
  const RigidMotion motion = some_motion();
  for (const StrandState& s : strand_states()) {
    const VectorXd x = motion.points(s.x), dx = VectorXd::LinSpaced(x.size(), -1, 1);
    const double E = stretch_energy(s.strand, s.x);
    SCOPED_TRACE(s.name);
    // Positions of a few metres round by 8 u, lengths by 16 u, energies by EA / l0 times that, and by their
    // own rounding.
    EXPECT_NEAR(stretch_energy(s.strand, x), E, 64 * kUnit * (std::sqrt(E * 50 * 6) * 10 + E) + 1e-28);
    EXPECT_LE((stretch_force(s.strand, x) - motion.vectors(stretch_force(s.strand, s.x))).norm(),
              1e3 * 64 * kUnit / s.shortest);
    EXPECT_LE((stretch_product(s.strand, x, motion.vectors(dx), GeometricTerm::full) -
               motion.vectors(stretch_product(s.strand, s.x, dx, GeometricTerm::full)))
                  .norm(),
              1e3 * 64 * kUnit * stiffest_stretch(s) / s.shortest);
  }
}

// A strand whose points are at r(s) has E = EA/2 int (|r'| - 1)^2 ds.
TEST(StretchSprings, ApproachTheContinuumsEnergyToSecondOrder) {
  // r' has the length 1 + 0.1 sin(s), along a helix, so E is the integral of 0.01 sin^2 over 0 to 2, times
  // EA/2.
  const double EA = 25, exact = EA / 2 * 0.01 * (1 - std::sin(4.0) / 4);
  std::vector<double> errors;
  for (int n : {8, 16, 32, 64}) {
    Strand strand = test_strand(n + 1);
    strand.rest_length.setConstant(2.0 / n);
    VectorXd x = VectorXd::Zero(3 * n + 3);
    // Simpson's rule gives r, to an error of 1e-12 or so.
    for (int i = 0; i < n; ++i) {
      Vector3d sum = Vector3d::Zero();
      const int parts = 256;
      for (int k = 0; k <= parts; ++k) {
        const double s = (i + static_cast<double>(k) / parts) * 2 / n;
        const double weight = (k == 0 || k == parts) ? 1 : (k % 2 == 1 ? 4 : 2);
        sum += weight * (1 + 0.1 * std::sin(s)) * Vector3d(0.6 * std::cos(s), 0.6 * std::sin(s), 0.8);
      }
      x.segment<3>(3 * i + 3) = x.segment<3>(3 * i) + sum * (2.0 / n / parts / 3);
    }
    errors.push_back(std::abs(stretch_energy(strand, x) - exact));
  }
  for (std::size_t i = 1; i < errors.size(); ++i)
    EXPECT_NEAR(errors[i - 1] / errors[i], 4, 0.4)
        << "halving the segments, the " << i << "th time: second order";
}

TEST(StretchSprings, HangUnderTheirOwnWeightByRhoGLSquaredOver2E) {
  const hair::Material material;
  const double g = 9.81, L = 0.3, exact = material.density * g * L * L / (2 * material.young_modulus);
  for (int n : {1, 2, 5, 30, 1000}) {
    const Strand strand = hair::uniform_strand(material, n, L);
    VectorXd x = VectorXd::Zero(3 * n + 3);
    // Each segment carries the weight below it.
    double below = strand.mass.sum();
    for (int i = 0; i < n; ++i) {
      below -= strand.mass[i];
      x[3 * i + 5] = x[3 * i + 2] - strand.rest_length[i] * (1 + below * g / strand.stretch_rigidity);
    }
    EXPECT_NEAR(-x[3 * n + 2] - L, exact, 8 * n * kUnit * L) << n << " segments; bound: rounding of n sums";
    const VectorXd f = stretch_force(strand, x);
    for (int i = 1; i <= n; ++i)  // A length is known to u L.
      EXPECT_NEAR(f[3 * i + 2], strand.mass[i] * g, 4 * kUnit * L * strand.stretch_rigidity / (L / n))
          << "in balance at particle " << i << " of " << n;
  }
}

TEST(StretchSprings, SwingAxiallyAtTheKnownFrequencies) {
  for (int n : {1, 2, 7, 30}) {
    const Strand strand = hair::uniform_strand({}, n, 0.3);
    const double k = strand.stretch_rigidity * n / 0.3, m = hair::Material().line_density() * 0.3 / n;
    VectorXd x = VectorXd::Zero(3 * n + 3);
    for (int i = 0; i <= n; ++i) x[3 * i + 2] = -0.3 * i / n;
    // The axial part of M^-1/2 K M^-1/2, root fixed.
    MatrixXd A(n, n);
    for (int j = 1; j <= n; ++j) {
      const VectorXd column =
          -stretch_product(strand, x, VectorXd::Unit(x.size(), 3 * j + 2), GeometricTerm::full);
      for (int i = 1; i <= n; ++i)
        A(i - 1, j - 1) = column[3 * i + 2] / std::sqrt(strand.mass[i] * strand.mass[j]);
    }
    const VectorXd squared = solver::symmetric_eigenvalues(A);
    for (int j = 1; j <= n; ++j) {
      const double omega = 2 * std::sqrt(k / m) * std::sin((2 * j - 1) * pi / (4 * n));
      EXPECT_NEAR(squared[j - 1], omega * omega, 16 * n * kUnit * 4 * k / m)
          << "mode " << j << " of " << n << "; bound: rounding, of the largest eigenvalue 4 k/m";
    }
  }
}

TEST(StretchSprings, AllocateNothing) {
  const StrandState s = strand_states()[2];
  VectorXd out = VectorXd::Zero(s.x.size());
  const long before = allocations();
  ASSERT_GT(before, 0) << "nothing is counted";
  stretch_energy(s.strand, s.x);
  add_stretch_force(s.strand, s.x, out);
  add_stretch_product(s.strand, s.x, GeometricTerm::filtered, s.x, out);
  EXPECT_EQ(allocations(), before);
}

}  // namespace
}  // namespace reference_tests
