// STAFF ONLY. Maps: the measured boundary is where theory has it, and classes are what they say. Theory's
// limits are those of the spectral radius of a step's matrix: just below a limit it is at most 1.

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <atomic>
#include <cmath>
#include <limits>

#include "hair/lab/stability/maps.h"
#include "hair/lab/stability/theory.h"
#include "hair/simulation/test_hairs.h"
#include "solver/dense_algebra.h"

namespace reference_tests {
namespace {

using hair::Fate;

using Eigen::MatrixXd, Eigen::VectorXd;

Description hanging_hair(int segments) {
  Description description = alone(straight_hair(segments, 0.01 * segments), Method::symplectic_euler, 1e-3);
  description.gravity = kG * kDown;
  description.strands[0].strand.bend_rigidity = 0;
  return description;
}

hair::StudyMethod method_of(Method method, hair::GeometricTerm term = hair::GeometricTerm::filtered) {
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
      expect_theory(hanging_hair(1), method_of(method), sweep, settings);
}

TEST(StabilityMaps, ImplicitMethodsBreakAcrossTheHair) {
  hair::MapSettings settings;
  settings.implicit_steps = 800;
  for (const double bending : {0.0, 1.0}) {
    Description hair = hanging_hair(2);
    hair.strands[0].strand.bend_rigidity = bending * straight_hair(2, 0.02).strand.bend_rigidity;
    for (const auto sweep : {hair::Swept::stiffness, hair::Swept::drag}) {
      expect_theory(hair, method_of(Method::implicit_euler, hair::GeometricTerm::dropped), sweep, settings);
      expect_theory(hair, method_of(Method::predictor_corrector, hair::GeometricTerm::filtered), sweep,
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

// Gelfand's formula, |A^N|^(1/N) with N = 2^40: the factor between the power's norm and the radius' power has
// a logarithm of at most some tens, divided by N.
double spectral_radius(MatrixXd power) {
  double logarithm = 0;
  for (int k = 0; k < 40; ++k) {
    const double size = power.norm();
    if (size == 0) return 0;
    logarithm += std::ldexp(std::log(size), -k);
    power = (power / size * (power / size)).eval();
  }
  return std::exp(logarithm);
}

TEST(StabilityTheory, ExplicitLimitsHaveTheirClosedForms) {
  const double w = 7;
  for (const double zeta : {0.0, 0.2, 1.0, 4.0}) {
    const hair::Oscillator one{w, 2 * zeta * w};
    const double root = zeta > 1 ? std::sqrt(zeta * zeta - 1) : 0;
    EXPECT_NEAR(hair::explicit_limit(Method::forward_euler, one),
                zeta <= 1 ? 2 * zeta / w : 2 / (w * (zeta + root)), 1e-9);
    EXPECT_NEAR(hair::explicit_limit(Method::symplectic_euler, one),
                2 * (std::sqrt(1 + zeta * zeta) - zeta) / w, 1e-12);
  }
  EXPECT_EQ(hair::explicit_limit(Method::forward_euler, {w}), 0);
  EXPECT_EQ(hair::explicit_limit(Method::midpoint, {w}), 0);
  EXPECT_NEAR(hair::explicit_limit(Method::runge_kutta_4, {w}) * w, 2 * std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(hair::explicit_limit(Method::runge_kutta_4, {0, w}) * w, 2.785293563, 1e-8);
}

TEST(StabilityTheory, StrongDragMakesTheSlowestModeBindForwardEuler) {
  const hair::Oscillator fast{10, 16}, slow{0.1, 16};  // gamma = 1.6 omega: the fast one is not overdamped
  EXPECT_LT(hair::explicit_limit(Method::forward_euler, slow),
            hair::explicit_limit(Method::forward_euler, fast));
}

// Three masses, K and P neither commuting nor diagonal.
struct System {
  VectorXd mass = Eigen::Vector3d(1, 2, 0.5);
  MatrixXd k = (MatrixXd(3, 3) << 9, -2, 1, -2, 7, 3, 1, 3, 8).finished();
  MatrixXd p = (MatrixXd(3, 3) << 2, 1, 0, 1, 3, -1, 0, -1, 1).finished();
};

MatrixXd implicit_step(const System& s, double gamma, double h) {
  const MatrixXd m = s.mass.asDiagonal();
  const MatrixXd left = solver::dense_solve(m + h * gamma * m + h * h * s.p, MatrixXd::Identity(3, 3));
  const MatrixXd from_x = -h * left * s.k;
  const MatrixXd from_v = MatrixXd::Identity(3, 3) - left * (h * gamma * m + h * h * s.p);
  MatrixXd step(6, 6);
  step << MatrixXd::Identity(3, 3) + h * from_x, h * from_v, from_x, from_v;
  return step;
}

// Maps (x, v) to w, then x' = x + h w, then v' of w and x' (theory.h).
MatrixXd predictor_corrector_step(const System& s, double gamma, double h) {
  const MatrixXd m = s.mass.asDiagonal(), left = (1 + h * gamma / 2) * m + h * h / 2 * s.p;
  const MatrixXd from_v = solver::dense_solve(left, m), from_x = solver::dense_solve(left, -h / 2 * s.k);
  MatrixXd w(3, 6), step(6, 6);
  w << from_x, from_v;
  step.topRows(3) = h * w;
  step.topLeftCorner(3, 3).diagonal().array() += 1;
  step.bottomRows(3) = from_v * w + from_x * step.topRows(3);
  return step;
}

TEST(StabilityTheory, ImplicitLimitsAreWhereTheStepsMatrixGrows) {
  const System s;
  for (const double gamma : {0.0, 0.5, 5.0}) {
    const struct {
      double limit;
      MatrixXd (*step)(const System&, double gamma, double h);
    } methods[] = {{hair::implicit_limit(s.mass, s.k, s.p, gamma), implicit_step},
                   {hair::predictor_corrector_limit(s.mass, s.k, s.p, gamma, 1e3), predictor_corrector_step}};
    for (const auto& [limit, step] : methods) {
      SCOPED_TRACE("gamma " + std::to_string(gamma) + ", h " + std::to_string(limit));
      ASSERT_TRUE(std::isfinite(limit));
      EXPECT_LE(spectral_radius(step(s, gamma, 0.999 * limit)), 1 + 1e-7);
      EXPECT_GT(spectral_radius(step(s, gamma, 1.001 * limit)), 1 + 1e-9);
      // The smallest limit of several modes: no error grows with any smaller step.
      for (int k = 1; k < 200; ++k)
        EXPECT_LE(spectral_radius(step(s, gamma, k / 200.0 * limit)), 1 + 1e-7) << k;
    }
  }
  EXPECT_TRUE(std::isinf(hair::implicit_limit(s.mass, s.k, s.k, 0)));  // the whole derivative: none
}

}  // namespace
}  // namespace reference_tests
