// STAFF ONLY. Maps: the measured boundary is where theory has it, few runs find what all find, and classes are what
// they say.

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>

#include "hair/stability/maps.h"
#include "hair/stability/theory.h"
#include "reference/tests/strands/hairs.h"

namespace reference_tests {
namespace {

using hair::Fate;

const std::atomic<bool> kNeverInterrupted = false;

Description hanging_hair(int segments) {
  Description description = alone(straight_hair(segments, 0.01 * segments), Method::symplectic_euler, 1e-3);
  description.gravity = kG * kDown;
  description.strands[0].strand.bend_rigidity = 0;
  return description;
}

hair::StudyMethod explicit_method(Method method) {
  hair::StudyMethod one;
  one.id = one.name = name_of(method);
  one.method = method;
  one.is_explicit = true;
  return one;
}

hair::StudyMethod implicit_method(Method method, hair::GeometricTerm term) {
  hair::StudyMethod one;
  one.id = one.name = name_of(method);
  one.method = method;
  one.geometric_term = term;
  return one;
}

// The boundary is between two cells, and theory within one of them: a cell at most. What the last limit says is what a
// run of so many steps can show, where that is different from the method's.
void expect_theory(const hair::StabilityMap& map, int columns_at_least) {
  const hair::Distance& distance = map.distances.back();
  EXPECT_GE(distance.columns, columns_at_least) << map.method.name;
  EXPECT_LE(std::abs(distance.worst_cells), 1)
      << map.method.name << (map.sweep == hair::Sweep::drag ? ", drag" : ", stiffness") << ", "
      << map.limits.back().name;
}

TEST(StabilityMaps, ExplicitMethodsBreakWhereTheClosedFormsSay) {
  hair::MapSettings settings;
  settings.columns = settings.rows = 32;
  for (const Method method : kExplicitMethods)
    for (const auto sweep : {hair::Sweep::stiffness, hair::Sweep::drag})
      expect_theory(
          hair::make_map(hanging_hair(1), explicit_method(method), sweep, settings, kNeverInterrupted), 30);
}

TEST(StabilityMaps, ImplicitMethodsBreakAcrossTheHairOrNotAtAll) {
  hair::MapSettings settings;
  settings.columns = settings.rows = 24;
  const Description hair = hanging_hair(2);
  const auto map = [&](Method method, hair::GeometricTerm term) {
    return hair::make_map(hair, implicit_method(method, term), hair::Sweep::stiffness, settings,
                          kNeverInterrupted);
  };
  expect_theory(map(Method::implicit_euler, hair::GeometricTerm::dropped), 24);
  expect_theory(map(Method::predictor_corrector, hair::GeometricTerm::filtered), 24);
  const hair::StabilityMap whole = map(Method::implicit_euler, hair::GeometricTerm::filtered);
  for (const double h : whole.boundary) EXPECT_TRUE(std::isinf(h)) << "H4 broke at " << h;
  // Without bending both limits are 2/omega_t; two masses, the tip half as heavy.
  const hair::Hanging hanging = hair::hang(hair, 1, false);
  const double expected = 2 / hanging.across_modes.omega.maxCoeff();
  const hair::StabilityMap dropped = map(Method::implicit_euler, hair::GeometricTerm::dropped);
  EXPECT_NEAR(dropped.limits[0].h[12] / expected, 1, 1e-3);
}

TEST(StabilityMaps, FewRunsFindTheBoundaryOfAll) {
  hair::MapSettings settings;
  settings.evaluations = 1000;
  const Description description =
      hair::with_options(hanging_hair(2), explicit_method(Method::symplectic_euler));
  const hair::StabilityMap map = hair::make_map(description, explicit_method(Method::symplectic_euler),
                                                hair::Sweep::stiffness, settings, kNeverInterrupted);
  EXPECT_LE(10 * map.grid.asked, 64 * 64);
  const double cell = std::log(map.hs[1] / map.hs[0]);
  for (std::size_t column = 0; column < map.xs.size(); ++column) {
    const hair::Hanging hanging = hair::hang(description, map.xs[column], false);
    const hair::Disturbance disturbance = hair::disturb(hanging);
    double boundary = 0;
    for (std::size_t row = 0; row < map.hs.size() && boundary == 0; ++row)
      if (hair::run_disturbed(description, hanging, disturbance, 0, map.hs[row], map.steps).fate >=
          Fate::wrong)
        boundary = std::sqrt(map.hs[row - 1] * map.hs[row]);
    EXPECT_LE(std::abs(std::log(map.boundary[column] / boundary)), 1.001 * cell) << "column " << column;
  }
}

TEST(StabilityMaps, ClassesAreWhatTheySay) {
  const auto judged = [](double energy, double kinetic, double truth) {
    hair::Judge judge;
    judge.look(Eigen::Vector2d(energy, energy), kinetic, truth);
    return judge.outcome().fate;
  };
  EXPECT_EQ(judged(1, 0, 1), Fate::stable);
  EXPECT_EQ(judged(99, 0, 1), Fate::stable);
  EXPECT_EQ(judged(101, 0, 1), Fate::wrong);
  EXPECT_EQ(judged(101, 1.1, 1), Fate::blown_up);
  EXPECT_EQ(judged(std::nan(""), 0, 1), Fate::blown_up);
  EXPECT_EQ(judged(0.09, 0, 1), Fate::damped_out);
  EXPECT_EQ(judged(0.09, 0, 0.5), Fate::stable);   // drag took the rest
  EXPECT_EQ(judged(1e-9, 0, 1e-3), Fate::stable);  // nothing is left to compare with
  hair::Judge judge;                               // what was wrong once stays so
  judge.look(Eigen::Vector2d(1, 200), 0, 1);
  judge.look(Eigen::Vector2d(0, 0), 0, 1);
  EXPECT_EQ(judge.outcome().fate, Fate::wrong);
}

TEST(StabilityMaps, AnOscillatorsEnergyIsThatOfItsEquation) {
  for (const double zeta : {0.0, 0.2, 1.0, 3.0}) {
    const double omega = 5, gamma = 2 * zeta * omega, h = 1e-5;
    double x = 0, v = 1;
    for (int k = 0; k < 40'000; ++k) {  // the midpoint rule, exact to 1e-9 here
      const double x_mid = x + h / 2 * v, v_mid = v + h / 2 * (-omega * omega * x - gamma * v);
      x += h * v_mid;
      v += h * (-omega * omega * x_mid - gamma * v_mid);
    }
    EXPECT_NEAR(hair::oscillator_energy(omega, gamma, 0.4), v * v + omega * omega * x * x, 1e-7)
        << "zeta " << zeta;
  }
}

}  // namespace
}  // namespace reference_tests
