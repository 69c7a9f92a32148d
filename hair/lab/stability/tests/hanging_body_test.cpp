// STAFF ONLY. Hanging links: their frequencies are those of closed forms, and methods break at the limits of
// theory.
#include "hair/lab/stability/hanging_body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "hair/io/files/bad_input.h"
#include "hair/lab/stability/station.h"
#include "hair/simulation/models.h"

namespace reference_tests {
namespace {

using Eigen::VectorXd;
using hair::Description, hair::Fate, hair::HangingBody, hair::Method;

constexpr double kLength = 0.1;

Description links(int count) {
  hair::StrandSpec spec;
  spec.elements = count;
  spec.length = kLength;
  Description description;
  description.modelled = {{hair::find_model("rigid_links"), spec}};
  description.method = Method::implicit_euler;
  return description;
}

const hair::Material& material_of(const Description& hair) {
  return hair.modelled[0].spec.fibre.material;
}

// Half a rod twists at the clamp: the chain continues behind it as in a mirror that reverses motions, and at
// the tip as in a mirror that does not. So its waves are sines, and their frequencies (2 c / l) sin((2j - 1)
// pi / (4 n)).
TEST(HangingBody, TwistsAsInTheClosedFormWithoutDrag) {
  constexpr int kLinks = 6;
  const Description description = links(kLinks);
  const HangingBody hanging = hair::hang_body(description, 1);
  std::vector<double> twists;
  for (Eigen::Index i = 0; i < hanging.modes.omega.size(); ++i)
    if (hanging.drag_per_mass[i] < 1e-6 * hanging.drag_per_mass.maxCoeff())
      twists.push_back(hanging.modes.omega[i]);
  ASSERT_EQ(twists.size(), kLinks);
  const double speed = std::sqrt(material_of(description).shear_modulus / material_of(description).density);
  for (int j = 1; j <= kLinks; ++j) {
    const double omega =
        2 * speed / (kLength / kLinks) * std::sin((2 * j - 1) * std::numbers::pi / (4 * kLinks));
    EXPECT_NEAR(twists[j - 1], omega, 1e-6 * omega) << j;  // energies by differences: 1e-8, of squares
  }
  EXPECT_EQ(hanging.fastest(), hanging.fastest_with_drag(false));
}

// Euler and Bernoulli's clamped beam, 1.8751^2 sqrt(EI / (rho A)) / L^2: of second order in the links'
// length. Twice the modulus is sqrt(2) times the frequency.
TEST(HangingBody, SwingsWithoutWeightAsABeam) {
  Description description = links(5);
  description.gravity.setZero();
  const hair::Material& material = material_of(description);
  const double beam = 1.875104 * 1.875104 * std::sqrt(material.bend_rigidity() / material.line_density()) /
                      (kLength * kLength);
  const auto slowest = [](const Description& hair, double stiffness) {
    return hair::hang_body(hair, stiffness).modes.omega[0];
  };
  const double coarse = slowest(description, 1) - beam;
  Description fine = links(10);
  fine.gravity.setZero();
  EXPECT_LE(std::abs(coarse), 0.02 * beam);
  EXPECT_NEAR(coarse / (slowest(fine, 1) - beam), 4, 0.3);
  EXPECT_NEAR(slowest(description, 2) / slowest(description, 1), std::sqrt(2), 1e-5);
}

// Drag c per metre damps motions across with c / (rho A); a rod's own thickness adds (r / l)^2 to its
// inertia.
TEST(HangingBody, DragDampsWhatMovesAcross) {
  const Description description = links(5);
  const HangingBody hanging = hair::hang_body(description, 1);
  const double expected = 1 / material_of(description).line_density();
  int across = 0;
  for (const double one : hanging.drag_per_mass)
    if (one > expected / 2) {
      ++across;
      EXPECT_NEAR(one, expected, 1e-4 * expected);
    }
  EXPECT_EQ(across, 10);
}

TEST(HangingBody, AHingedStrandHasNothingThatTwistsItBack) {
  Description description = links(3);
  description.modelled[0].spec.clamped = false;
  EXPECT_THROW(hair::hang_body(description, 1), hair::BadInput);
}

// The first wrong h, by bisection to a thousandth; bounds as in stability_maps_test.
void expect_limit(Method method, double stiffness, double drag, long steps) {
  Description description = links(10);
  description.method = method;
  hair::StudyMethod one;
  one.method = method;
  const hair::Station station = hair::make_station(description, one, stiffness, drag);
  const double growth = std::pow(hair::kWrongGrowth, 0.5 / static_cast<double>(steps));
  const double theory = station.limit(growth, 1);
  ASSERT_TRUE(std::isfinite(theory));
  const auto wrong = [&](double h) { return station.run(h, steps).fate >= Fate::wrong; };
  double low = theory / 2, high = 2 * theory;
  ASSERT_FALSE(wrong(low)) << low << " s";
  ASSERT_TRUE(wrong(high)) << high << " s";
  while (high > 1.001 * low) (wrong(std::sqrt(low * high)) ? high : low) = std::sqrt(low * high);
  const double off = low / theory - 1;
  EXPECT_TRUE(off > -0.021 && off < 0.01)
      << hair::row_of(method).name << ", stiffness " << stiffness << ", drag " << drag << ": " << low
      << " s, theory " << theory << " s";
}

TEST(HangingBody, MethodsBreakWhereTheoryHasIt) {
  for (const double stiffness : {0.03, 1.0, 30.0}) {
    expect_limit(Method::symplectic_euler, stiffness, 0, 4000);
    expect_limit(Method::runge_kutta_4, stiffness, 0, 4000);
  }
  // The drag is above the twists' frequency and sets the limit.
  expect_limit(Method::symplectic_euler, 1, 3, 4000);
  expect_limit(Method::runge_kutta_4, 1, 3, 4000);
  for (const double stiffness : {1e-3, 1e-2}) expect_limit(Method::implicit_euler, stiffness, 0, 2000);
}

}  // namespace
}  // namespace reference_tests
