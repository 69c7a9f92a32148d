// STAFF ONLY. Stiff and extreme strands: the reference stays finite where its method promises it. Otherwise
// the simulation reports which strand broke, at which step and in which stage. It never gives NaN without a
// report, and never hangs.
//
// The methods' promises: H4 with definite products and H6 solve symmetric positive definite systems, and
// never break, with any step, as long as numbers have enough digits: rounding is 2^-53 of the largest entry,
// about k h^2, and must be far below the smallest, a mass. Explicit methods break as soon as h is above their
// limit; without damping, forward Euler breaks at any step.
//
// Then strands against closed forms: wavy and curly hair keeps its shape, and returns to it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "hair/simulation/test_hairs.h"
#include "hair/strand/measures.h"

namespace reference_tests {
namespace {

struct Case {
  std::string name;
  StrandStart start;
};

Eigen::VectorXd zigzag(int n, double length) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(3 * n);
  for (int i = 1; i < n; i += 2) x[3 * i] = length;
  return x;
}

struct ExtremeState {
  const char* name;
  void (*change)(particles::State& state);  // the strand has at least four particles
};
const ExtremeState kExtremeStates[] = {
    {"all particles in one place", [](particles::State& state) { state.x.setZero(); }},
    {"two neighbours in one place",
     [](particles::State& state) { state.x.segment<3>(9) = Eigen::Vector3d(state.x.segment<3>(6)); }},
    {"compressed to 1 %", [](particles::State& state) { state.x *= 0.01; }},
    {"stretched to 300 %", [](particles::State& state) { state.x *= 3; }},
    {"folded at pi",
     [](particles::State& state) { state.x = zigzag(static_cast<int>(state.x.size() / 3), 0.01); }},
    {"nearly folded",
     [](particles::State& state) {
       state.x = zigzag(static_cast<int>(state.x.size() / 3), 0.01);
       for (Eigen::Index i = 0; i < state.x.size() / 3; ++i)
         state.x[3 * i + 1] = 1e-9 * static_cast<double>(i);
     }},
    {"a root flung at 100 m/s", [](particles::State& state) { state.v.head<3>() = Vector3d(60, 80, 0); }},
};

// Curls that methods must not break.
std::vector<Case> extreme_curls() {
  const StrandStart at_rest = hair::start_at_rest({}, hair::curly_shape(12, 0.12, 0.01, 0.02, {}));
  std::vector<Case> all = {{"a curl, at rest", at_rest}};
  for (const ExtremeState& state : kExtremeStates) {
    all.push_back({std::string("a curl, ") + state.name, at_rest});
    state.change(all.back().start.state);
  }
  return all;
}

// Strands that methods must not break, of hair `stiffer` times as stiff in stretching and bending.
std::vector<Case> extreme_strands(double stiffer) {
  hair::Material material;
  material.young_modulus *= stiffer;
  std::vector<Case> all;
  const auto add = [&](const std::string& name, int segments, auto change) {
    all.push_back({name, straight_hair(segments, 0.01 * std::max(segments, 1), Vector3d::UnitX(), material)});
    change(all.back().start);
  };
  const auto as_it_is = [](StrandStart&) {};

  all.push_back({"1 particle",
                 {hair::strand_from_rest(material, Eigen::VectorXd::Zero(3)),
                  {Eigen::VectorXd::Zero(3), Eigen::VectorXd::Zero(3)}}});
  add("2 particles", 1, as_it_is);
  add("3 particles, collinear", 2, as_it_is);
  add("10 segments, level", 10, as_it_is);
  for (const ExtremeState& state : kExtremeStates)
    add(state.name, 6, [&](StrandStart& start) { state.change(start.state); });
  add("a tip of 1e6 times the mass", 6, [](StrandStart& start) { start.strand.mass[6] *= 1e6; });
  add("a tip of 1e-6 times the mass", 6, [](StrandStart& start) { start.strand.mass[6] *= 1e-6; });
  add("masses that alternate by 1e6", 6, [](StrandStart& start) {
    for (int i = 1; i < 7; i += 2) start.strand.mass[i] *= 1e6;
  });
  add("a root flung at 100 m/s along the hair", 6,
      [](StrandStart& start) { start.state.v.head<3>() = Vector3d(100, 0, 0); });
  add("rest lengths that alternate by 1e4", 6, [](StrandStart& start) {
    for (int i = 0; i < 6; i += 2) start.strand.rest_length[i] *= 1e-4;
  });
  return all;
}

bool all_finite(const particles::State& state) {
  return state.x.allFinite() && state.v.allFinite();
}

// Takes the steps one by one: NaN or an infinity without a report is a failure. Returns true if it broke.
bool breaks(const Case& extreme, Description description, int steps) {
  description.gravity = kG * kDown;
  const std::string name =
      extreme.name + ", " + name_of(description.method) + ", h = " + std::to_string(description.step) + " s";
  Simulation simulation(std::move(description));
  for (int step = 1; step <= steps; ++step) {
    const auto blow_up = simulation.step();
    if (blow_up) {
      EXPECT_EQ(blow_up->strand, 0) << name;
      EXPECT_EQ(blow_up->step, step) << name;
      return true;
    }
    EXPECT_TRUE(all_finite(simulation.state(0)))
        << name << ", step " << step << ": not finite, and not reported";
  }
  return false;
}

constexpr double kStiffer[] = {1, 1e3, 1e6};
constexpr double kStepLengths[] = {1e-6, 1e-4, 1e-2, 0.1};

// True if masses exceed the rounding of k h^2 by 2^10.
bool is_within_reach(const hair::Strand& strand, double h) {
  if (strand.segments() == 0) return true;
  const double k = strand.stretch_rigidity / strand.rest_length.minCoeff();
  return k * h * h * 0x1p-53 * 0x1p10 <= strand.mass.minCoeff();
}

TEST(Extremes, ImplicitEulerNeverBreaks) {
  int within_reach = 0;
  for (const double stiffer : kStiffer)
    for (const Case& extreme : extreme_strands(stiffer))
      for (const double h : kStepLengths) {
        const bool broke = breaks(extreme, alone(extreme.start, Method::implicit_euler, h), 30);
        if (!is_within_reach(extreme.start.strand, h)) continue;
        ++within_reach;
        EXPECT_FALSE(broke) << extreme.name << ", " << stiffer << " times as stiff, h = " << h;
      }
  EXPECT_GT(within_reach, 150);  // out of 192
}

TEST(Extremes, ThePredictorCorrectorNeverBreaksAndKeepsLengths) {
  int within_reach = 0;
  for (const double stiffer : kStiffer)
    for (const Case& extreme : extreme_strands(stiffer))
      for (const double h : kStepLengths) {
        const Description description = alone(extreme.start, Method::predictor_corrector, h);
        const bool broke = breaks(extreme, description, 30);
        const hair::Strand& strand = extreme.start.strand;
        if (!is_within_reach(strand, h)) continue;
        ++within_reach;
        EXPECT_FALSE(broke) << extreme.name << ", " << stiffer << " times as stiff, h = " << h;
        Simulation simulation(description);
        simulation.advance(5);
        // 2^-51 x / l0 is the precision of the shortest segment's length for coordinates of up to 50 m.
        const double x = simulation.state(0).x.cwiseAbs().maxCoeff();
        const double rounding = strand.segments() == 0 ? 0 : 0x1p-50 * x / strand.rest_length.minCoeff();
        EXPECT_LE(hair::largest_stretch(simulation.strand(0), simulation.state(0).x), 1e-10 + rounding)
            << extreme.name << ", " << stiffer << " times as stiff, h = " << h;
      }
  EXPECT_GT(within_reach, 150);  // out of 192
}

TEST(Extremes, CurlsNeverBreak) {
  for (const Method method : {Method::implicit_euler, Method::predictor_corrector})
    for (const Case& extreme : extreme_curls())
      for (const double h : {1e-6, 1e-5, 1e-4, 1e-3, 1.0 / 240, 1.0 / 60, 0.1})
        EXPECT_FALSE(breaks(extreme, alone(extreme.start, method, h), 100))
            << extreme.name << ", " << name_of(method) << ", h = " << h;
}

// Without the geometric term only the explicit force holds a taut hair laterally, with a limit of its own;
// with exact derivatives the system is indefinite in compression, and ConjGrad ends early. There is no
// promise for either. But every break must be reported.
TEST(Extremes, OtherJacobiansAreNeverNaNInSilence) {
  for (const double stiffer : kStiffer)
    for (const Case& extreme : extreme_strands(stiffer))
      for (const double h : kStepLengths)
        for (const auto term : {hair::GeometricTerm::dropped, hair::GeometricTerm::full}) {
          Description description = alone(extreme.start, Method::implicit_euler, h);
          description.geometric_term = term;
          description.bend_product = particles::Products::exact;
          breaks(extreme, description, 30);
        }
}

TEST(Extremes, ExplicitMethodsBreakAloud) {
  for (Method method : kExplicitMethods)
    for (const double stiffer : kStiffer)
      for (const Case& extreme : extreme_strands(stiffer))
        for (const double h : kStepLengths) breaks(extreme, alone(extreme.start, method, h), 200);
}

TEST(Extremes, TenThousandParticles) {
  // 100 m of hair, in segments of 1 cm; with h = 1e-5 s a wave crosses 1.5 of them in a step.
  for (Method method : {Method::symplectic_euler, Method::implicit_euler, Method::predictor_corrector}) {
    const double h = method == Method::symplectic_euler ? 1e-6 : 1e-5;
    Description description = alone(straight_hair(9'999, 99.99, Vector3d::UnitX()), method, h);
    description.gravity = kG * kDown;
    description.strands[0].state.v.head<3>() = Vector3d(0, 1, 0);
    Simulation simulation(std::move(description));
    EXPECT_FALSE(simulation.advance(10)) << name_of(method);
    EXPECT_EQ(simulation.work().unconverged, 0) << name_of(method);
    // The far end falls freely: the motion of the root has not reached it.
    const double t = 10 * h;
    EXPECT_NEAR(particle(simulation, 9'999)[2], -kG * t * t / 2, 0.2 * kG * t * t / 2) << name_of(method);
    if (method == Method::predictor_corrector) {
      EXPECT_LE(hair::largest_stretch(simulation.strand(0), simulation.state(0).x), 1e-10);
    }
  }
}

hair::Measures measures(const Simulation& simulation) {
  return hair::measure(simulation.strand(0), simulation.particles(0), simulation.force(0),
                       simulation.state(0));
}

// A hair that hangs at rest: segment i carries the weight of the part below its middle.
StrandStart hanging_hair(int segments, double length, const hair::Material& material = {}) {
  StrandStart start = straight_hair(segments, length, kDown, material);
  const hair::Strand& strand = start.strand;
  double weight = kG * strand.mass.sum(), z = 0;
  for (int i = 0; i < segments; ++i) {
    weight -= kG * strand.mass[i];
    z -= strand.rest_length[i] * (1 + weight / strand.stretch_rigidity);
    start.state.x[3 * i + 5] = z;
  }
  return start;
}

// A hair that turns about its root as a whole: sum m r^2 w, at any position. A lever is accurate to 2^-51 m
// there, and again in the velocity.
TEST(StrandPhysics, AngularMomentumIsAboutTheRoot) {
  StrandStart start = straight_hair(10, 0.1);
  const Vector3d root(3, -2, 1), turn(0, 7, 0);
  double inertia = 0;
  for (int i = 0; i <= 10; ++i) {
    const Vector3d lever = start.state.x.segment<3>(3 * i);
    inertia += start.strand.mass[i] * lever.squaredNorm();
    start.state.v.segment<3>(3 * i) = turn.cross(lever);
    start.state.x.segment<3>(3 * i) += root;
  }
  const double bound = 2 * 0x1p-51 * start.strand.mass.sum() * 0.1 * turn.norm();
  const Simulation simulation(alone(std::move(start), Method::implicit_euler, 0.01));
  EXPECT_LE((measures(simulation).angular_momentum - inertia * turn).norm(), bound);
}

TEST(StrandPhysics, StretchUnderItsOwnWeightIsRhoGLSquaredOver2EForAnyNumberOfSegments) {
  const double length = 0.3;
  const hair::Material soft{.young_modulus = 3e5};
  const double expected = soft.density * kG * length * length / (2 * soft.young_modulus);
  for (int n : {1, 2, 3, 10, 57}) {
    const StrandStart start = hanging_hair(n, length, soft);
    EXPECT_NEAR(-start.state.x[3 * n + 2] - length, expected, 1e-13) << n;

    // It is at the balance: no particle has a force above the rounding of the root's, ρ g L A.
    Description description = alone(start, Method::implicit_euler, 0.01);
    description.gravity = kG * kDown;
    const Simulation simulation(std::move(description));
    Eigen::VectorXd f = Eigen::VectorXd::Zero(3 * n + 3);
    simulation.force(0).add_force(start.state.x, start.state.v, f);
    const double weight = kG * start.strand.mass.sum();
    // A length is accurate to 2^-53 of x, and a spring's force to that times EA / l0.
    EXPECT_LE(f.tail(3 * n).cwiseAbs().maxCoeff(),
              8 * 0x1p-53 * (weight + start.strand.stretch_rigidity * length / (length / n)))
        << n;
  }
}

TEST(StrandPhysics, AHangingHairStaysAtRest) {
  for (Method method : kMethods) {
    const bool implicit = method == Method::implicit_euler || method == Method::predictor_corrector;
    // H6 has no stretch: the hair hangs straight down at its rest lengths.
    Description description =
        alone(method == Method::predictor_corrector ? straight_hair(10, 0.1) : hanging_hair(10, 0.1), method,
              implicit ? 1.0 / 240 : 1e-7);
    description.gravity = kG * kDown;
    const Eigen::VectorXd x = description.strands[0].state.x;
    Simulation simulation(std::move(description));
    ASSERT_FALSE(simulation.advance(100)) << name_of(method);
    const double fall = kG * simulation.time();
    // A solve to 1e-10 of a right-hand side of a (f + ...) leaves this part of gravity's effect in a step,
    // and rounding leaves 2^-53 EA / (m g) = 3e-7 of gravity.
    EXPECT_LE(simulation.state(0).v.cwiseAbs().maxCoeff(), 1e-4 * fall) << name_of(method);
    EXPECT_LE((simulation.state(0).x - x).cwiseAbs().maxCoeff(), 1e-6 * 0.1) << name_of(method);
  }
}

constexpr double kLength = 0.05;

hair::RestShape wave() {
  return hair::wavy_shape(12, kLength, 0.003, 0.02, {});
}

hair::RestShape curl() {
  return hair::curly_shape(12, kLength, 0.006, 0.015, {});
}

double farthest(const Eigen::VectorXd& difference) {
  double most = 0;
  for (Eigen::Index i = 0; i < difference.size(); i += 3)
    most = std::max(most, difference.segment<3>(i).norm());
  return most;
}

TEST(RestShapeMotion, WithoutGravityWavesAndCurlsStayPut) {
  for (Method method : kMethods)
    for (const hair::RestShape& shape : {wave(), curl()}) {
      const bool implicit = method == Method::implicit_euler || method == Method::predictor_corrector;
      Simulation simulation(alone(hair::start_at_rest({}, shape), method, implicit ? 1.0 / 240 : 1e-7));
      ASSERT_FALSE(simulation.advance(100)) << name_of(method);
      // Rounding of x changes lengths by 2^-53 x and causes forces of EA / l0 times that, 1e-12 N. An
      // explicit method moves a particle of 2.5e-8 kg by 1e-14 m within its 1e-5 s, an implicit one by as
      // much as bending yields.
      EXPECT_LE(farthest(simulation.state(0).x - shape.x), 1e-10 * kLength) << name_of(method);
    }
}

// Drag damps the swing: with 1e-3 N s/m^2 a hair of 1e-5 kg/m loses its velocity in 10 ms.
Description damped(const hair::RestShape& shape, Method method, double gravity) {
  Description description = alone(hair::start_at_rest({}, shape), method, 1.0 / 240);
  description.drag = 1e-3;
  description.gravity = gravity * kDown;
  return description;
}

TEST(RestShapeMotion, UnderGravityACurlSagsAndWithoutItComesBack) {
  for (Method method : {Method::implicit_euler, Method::predictor_corrector})
    for (const hair::RestShape& shape : {wave(), curl()}) {
      Simulation heavy(damped(shape, method, kG));
      ASSERT_FALSE(heavy.advance(240));
      const double sag = farthest(heavy.state(0).x - shape.x);
      EXPECT_GT(sag, 1e-3 * kLength) << name_of(method);

      Description again = damped(shape, method, 0);
      again.strands[0].state = heavy.state(0);
      Simulation weightless(std::move(again));
      ASSERT_FALSE(weightless.advance(480));
      EXPECT_LE(farthest(weightless.state(0).x - shape.x), 0.01 * sag) << name_of(method);
    }
}

}  // namespace
}  // namespace reference_tests
