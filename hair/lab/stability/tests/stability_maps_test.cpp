// STAFF ONLY. Maps: the measured boundary is where theory has it, and classes are what they say.

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "hair/lab/stability/maps.h"
#include "hair/lab/stability/tests/never_interrupted.h"
#include "hair/lab/stability/theory.h"
#include "hair/simulation/tests/hairs.h"

namespace reference_tests {
namespace {

using hair::Fate;

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
  return one;
}

hair::StudyMethod implicit_method(Method method, hair::GeometricTerm term) {
  hair::StudyMethod one;
  one.id = one.name = name_of(method);
  one.method = method;
  one.geometric_term = term;
  return one;
}

// The first wrong h, by bisection to a thousandth, between half of theory's limit, which is stable, and twice
// the limit.
double measured_limit(const Description& description, const hair::StabilityMap& map, std::size_t column,
                      double theory) {
  const bool stiffness = map.sweep == hair::Swept::stiffness;
  const double x = map.xs[column];
  const hair::Hanging hanging =
      hair::hang(description, stiffness ? x : 1, map.method.method == Method::predictor_corrector);
  const hair::Disturbance disturbance = hair::disturb(hanging);
  const auto wrong = [&](double h) {
    return hair::run_disturbed(description, hanging, disturbance, stiffness ? description.drag : x, h,
                               map.steps)
               .fate >= Fate::wrong;
  };
  double low = theory / 2, high = 2 * theory;
  if (wrong(low)) return 0;
  if (!wrong(high)) return std::numeric_limits<double>::infinity();
  while (high > 1.001 * low) (wrong(std::sqrt(low * high)) ? high : low) = std::sqrt(low * high);
  return low;
}

// Compares the curve of a map with runs of many steps, in columns from end to end. A method that keeps errors
// bounded exchanges energy, by 100 at 99/101 of its limit (experiment.h): 2 % too low, and the bisection adds
// a thousandth. A growth by 10 in so many steps, from which on it is seen, is less than 1 % beyond the limit,
// or the last curve gives its place.
void expect_theory(const Description& hair, const hair::StudyMethod& method, hair::Swept sweep,
                   const hair::MapSettings& few) {
  hair::MapSettings settings = few;
  settings.columns = 4;
  const std::atomic<bool> no_cells = true;
  const Description description = hair::with_options(hair, method);
  const hair::StabilityMap map = hair::make_map(hair, method, sweep, settings, no_cells);
  const bool in_drag = sweep == hair::Swept::drag;
  int compared = 0;
  for (std::size_t column = 0; column < map.xs.size(); ++column) {
    const double theory = map.limits.back().h[column];
    if (!std::isfinite(theory) || theory == 0) continue;
    const double off = measured_limit(description, map, column, theory) / theory - 1;
    EXPECT_TRUE(off > -0.021 && off < 0.01)
        << method.name << ", " << map.limits.back().name << ", " << map.xs[column]
        << (in_drag ? " of drag: " : " of stiffness: ") << off << " from " << theory << " s";
    ++compared;
  }
  EXPECT_GE(compared, settings.columns - 1) << method.name;
}

TEST(StabilityMaps, ExplicitMethodsBreakWhereTheClosedFormsSay) {
  hair::MapSettings settings;
  settings.evaluations = 20'000;
  for (const Method method : kExplicitMethods)
    for (const auto sweep : {hair::Swept::stiffness, hair::Swept::drag})
      expect_theory(hanging_hair(1), explicit_method(method), sweep, settings);
}

TEST(StabilityMaps, ImplicitMethodsBreakAcrossTheHair) {
  hair::MapSettings settings;
  settings.implicit_steps = 800;
  for (const double bending : {0.0, 1.0}) {
    Description hair = hanging_hair(2);
    hair.strands[0].strand.bend_rigidity = bending * straight_hair(2, 0.02).strand.bend_rigidity;
    for (const auto sweep : {hair::Swept::stiffness, hair::Swept::drag}) {
      expect_theory(hair, implicit_method(Method::implicit_euler, hair::GeometricTerm::dropped), sweep,
                    settings);
      expect_theory(hair, implicit_method(Method::predictor_corrector, hair::GeometricTerm::filtered), sweep,
                    settings);
    }
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
  hair::Judge judge;                               // a wrong run stays wrong
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
