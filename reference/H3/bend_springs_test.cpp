// STAFF ONLY. The lecture's criticism of bend springs as measurements. The public checks test the promises of
// hair/bend_springs.h.

#include "hair/bend_springs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hair/angular_springs.h"
#include "hair/strand/test_strand_states.h"
#include "hair/stretch_springs.h"
#include "solver/test_allocations.h"

namespace reference_tests {
namespace {

using hair::GeometricTerm;

VectorXd bend_spring_product(const Strand& strand, const VectorXd& x, const VectorXd& dx,
                             GeometricTerm term) {
  VectorXd result = VectorXd::Zero(x.size());
  add_bend_spring_product(strand, x, term, dx, result);
  return result;
}

TEST(BendSprings, ServeTenThousandParticlesAndAllocateNothing) {
  const Strand strand = test_strand(10000);
  VectorXd x(30000), f = VectorXd::Zero(30000), df = f;
  for (int i = 0; i < x.size(); ++i) x[i] = std::sin(1.0 * i * i);
  const long before = allocations();
  ASSERT_GT(before, 0) << "nothing is counted";
  EXPECT_TRUE(std::isfinite(bend_spring_energy(strand, x)));
  add_bend_spring_force(strand, x, f);
  add_bend_spring_product(strand, x, GeometricTerm::filtered, x, df);
  EXPECT_EQ(allocations(), before);
  EXPECT_TRUE(f.allFinite());
  EXPECT_TRUE(df.allFinite());
}

// The lecture says: "Difficulty: Each spring constant affects both bending and stretching". This measures a
// uniform strand of length 1 with n segments, stretched by 1 %, and bent into an arc of radius 1 with its
// rest lengths.
struct Measured {
  double stretch;  // the energy over EA strain^2 L / 2: it stretches like so many strands
  double bend;     // the energy over EI / R^2 L / 2 at EI = 1
};
Measured measured(int n, double EA, double S) {
  Strand strand = test_strand(n + 1);
  strand.rest_length.setConstant(1.0 / n);
  strand.stretch_rigidity = EA;
  strand.skip_rigidity = S;
  VectorXd stretched = VectorXd::Zero(3 * n + 3), arc = stretched;
  for (int i = 0; i < n; ++i) {
    stretched[3 * i + 3] = 1.01 * (i + 1) / n;
    arc.segment<3>(3 * i + 3) =
        arc.segment<3>(3 * i) + Vector3d(std::cos(1.0 * i / n), std::sin(1.0 * i / n), 0) / n;
  }
  auto energy = [&](const VectorXd& x) { return stretch_energy(strand, x) + bend_spring_energy(strand, x); };
  return {energy(stretched) / (1e-4 / 2), energy(arc) / 0.5};
}

TEST(BendSprings, StiffenAgainstStretchingByTwiceTheirRigidity) {
  // n - 1 springs of 2 L/n each make EA + 2 S (1 - 1/n).
  for (int n : {4, 8, 16, 32})
    for (double S : {0.0, 1.0, 10.0})
      EXPECT_NEAR(measured(n, 25, S).stretch, 25 + 2 * S * (1 - 1.0 / n), 1e-10 * (25 + 2 * S))
          << n << ", " << S;
}

TEST(BendSprings, ResistABendWithTheFourthPowerOfASegmentsLength) {
  // d = 2 l cos(phi/2), and so (d - d0)^2 = (4 l sin^2(phi/4))^2, (l phi^2 / 4)^2 for small phi: at the same
  // curvature the resistance falls by 16 when the segments are halved. So the meaning of a constant depends
  // on the sampling.
  for (int n : {8, 16, 32}) {
    const double l = 1.0 / n, phi = 1.0 / n, k = 10 / (2 * l);
    const double exact = (n - 1) * k * std::pow(4 * l * std::pow(std::sin(phi / 4), 2), 2);
    EXPECT_NEAR(measured(n, 25, 10).bend, exact, 1e-6 * exact)
        << n;  // d - d0 is known to u l, and is l phi^2 / 4
    EXPECT_NEAR(measured(n, 25, 10).bend / measured(2 * n, 25, 10).bend, 16, 32.0 / n) << n;
  }
}

TEST(BendSprings, ResistASmallBendNotAtAll) {
  // In the exact derivative of a straight strand a change across it costs nothing; angular springs have EI /
  // l^3 there.
  Strand strand = test_strand(3);
  strand.rest_length.setOnes();
  VectorXd x = VectorXd::Zero(9), across = x;
  x << 0, 0, 0, 0, 0, -1, 0, 0, -2;
  across[3] = 1;
  EXPECT_EQ(bend_spring_product(strand, x, across, GeometricTerm::full), VectorXd::Zero(9));
  VectorXd expected = VectorXd::Zero(9);
  expected[0] = expected[6] = 4 * 2;
  expected[3] = -4 * 4;
  VectorXd angular = VectorXd::Zero(9);
  add_bend_product(strand, x, across, angular);
  EXPECT_LE((angular - expected).norm(), 64 * kUnit * 16);
}

}  // namespace
}  // namespace reference_tests
