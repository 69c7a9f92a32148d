// STAFF ONLY. H8's functions, frames and Jacobians beyond its public checks: digits and jumps.

#include <gtest/gtest.h>

#include <cmath>

#include "reference/H8/super_helices_for_tests.h"

namespace reference_tests {
namespace {

using hair::HelixJacobian, hair::MaterialFrame;

// ---- Stumpff's functions

// c_k by its series with 64 bits of mantissa and the terms in pairs, or by the closed form for large x.
long double exact_stumpff(int k, long double x) {
  if (x > 100) {
    long double value = k % 2 == 0 ? std::cos(std::sqrt(x)) : std::sin(std::sqrt(x)) / std::sqrt(x);
    long double factorial = 1;
    for (int m = k % 2; m < k; m += 2) {
      value = (1 / factorial - value) / x;
      factorial *= (m + 1) * (m + 2);
    }
    return value;
  }
  long double term = 1, sum = 0;
  for (int m = 2; m <= k; ++m) term /= m;
  for (int m = k; m < k + 120; m += 2) {
    sum += term;
    term *= -x / ((m + 1) * (m + 2));
  }
  return sum;
}

double bound_of_stumpff(int k, double x) {
  const double bound = 1 / std::tgamma(k + 1);
  return k < 2 || x == 0 ? bound : std::min(bound, 2 / (std::tgamma(k - 1) * x));
}

// The bound allows a rounding of 1e-13; a^2 = x is known to half a unit, so cos a to a / 2 units.
TEST(Stumpff, HasItsDigitsForAllX) {
  std::vector<double> all = {0, 1e-300, 15791.4, 1e6, 4, std::nextafter(4, 0), std::nextafter(4, 5)};
  for (double x = 1e-12; x < 1e5; x *= 1.07) all.push_back(x);
  for (const double x : all) {
    const std::array<double, 8> c = hair::stumpff(x);
    for (int k = 0; k < 8; ++k)
      EXPECT_LE(std::abs(c[k] - exact_stumpff(k, x)), (2e-14 + 2e-16 * std::sqrt(x)) * bound_of_stumpff(k, x))
          << "c_" << k << "(" << x << ") = " << c[k];
  }
}

// ---- Centre line and frame

// Across the switch at |p| = 2, and at 0, pose and Jacobian change over a step of 1e-9 as the derivative
// says, to rounding over 1e-9. A jump of 1e-12 would show.
TEST(HelixFrames, HaveNoJump) {
  const MaterialFrame start;
  const Vector3d direction = Vector3d(1, 2, 3).normalized();
  for (const double size : {0.0, 1e-8, 1e-4, 2.0}) {
    const Vector3d before = (size - 1e-10) * direction, after = (size + 1e-10) * direction;
    const MaterialFrame a = hair::frame_at(start, before, 1), b = hair::frame_at(start, after, 1);
    const HelixJacobian J = hair::jacobian_at(start, size * direction, 1);
    EXPECT_LE((b.position - a.position - J.moves * (after - before)).norm(), 3e-16) << size;
    const HelixJacobian Ja = hair::jacobian_at(start, before, 1), Jb = hair::jacobian_at(start, after, 1);
    EXPECT_LE((Jb.moves - Ja.moves).norm() + (Jb.turns - Ja.turns).norm(), 2e-10) << size;
  }
}

}  // namespace
}  // namespace reference_tests
