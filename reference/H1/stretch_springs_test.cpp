// STAFF ONLY. H1 obeys physics and geometry. The public checks test the promises of hair/stretch_springs.h.

#include "hair/stretch_springs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hair/strand/test_strand_states.h"

namespace reference_tests {
namespace {

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

}  // namespace
}  // namespace reference_tests
