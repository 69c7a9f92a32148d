// STAFF ONLY. The energy balance of each model and method: work of roots, frames, drag and obstacles is no
// gain, and energy taken by drag and dampers is no loss; only energy from no source, or lost to none, counts.
#include "hair/strand/energy_watch.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <ostream>

#include "hair/simulation/models.h"
#include "hair/simulation/simulation.h"
#include "hair/strand/test_bodies.h"
#include "solver/test_numbers.h"

namespace hair {
namespace {

constexpr double kG = reference_tests::kGravity, kLength = 0.1;
constexpr double kStep = 1e-4;

// Methods of order one may be off by a few h of a second's motion: this is the largest error of a correct
// balance.
constexpr double kOrderOne = 0.02;

TEST(EnergyWatch, AGainDoesNotHideBehindALoss) {
  EnergyWatch watch(1, 1, 1);
  const double all = 1 + 5e-7;  // m g L, and 1 mm/s
  watch.begin({});
  watch.after_step({.weight = -0.5}, 0, false);
  watch.after_step({.kinetic = 0.1, .weight = -0.5}, 0, false);
  watch.after_step({.kinetic = 0.1, .weight = -0.6}, 0, false);
  EXPECT_DOUBLE_EQ(watch.gain(), 0.1 / all);
  EXPECT_DOUBLE_EQ(watch.loss(), 0.5 / all);
  EXPECT_EQ(watch.contact_gain(), 0);
}

TEST(EnergyWatch, WorkIsNoGainAndIsPartOfTheWhole) {
  EnergyWatch watch(1, 1, 1);
  watch.begin({});
  watch.after_step({.kinetic = 1}, 1, false);
  watch.root_moved({.kinetic = 3});
  EXPECT_EQ(watch.gain(), 0);
  watch.after_step({.kinetic = 4}, 0, true);
  EXPECT_EQ(watch.gain(), 0);
  EXPECT_DOUBLE_EQ(watch.contact_gain(), 1 / (4 + 5e-7));
  watch.after_step({.kinetic = 1}, -3, true);
  EXPECT_EQ(watch.loss(), 0);
}

// Stretching that the balance leaves out moves the strand later: its energy at the start is no gain.
TEST(EnergyWatch, WhatIsAsideAtTheStartMayComeIn) {
  EnergyWatch watch(1, 1, 1);
  watch.begin({.aside = 2});
  watch.after_step({.kinetic = 1.5}, 0, false);
  EXPECT_EQ(watch.gain(), 0);
  watch.after_step({.kinetic = 3}, 0, false);
  EXPECT_DOUBLE_EQ(watch.gain(), 1 / (3 + 5e-7));
}

// Drag would have taken the lost energy: of two losses some time apart only the second counts.
TEST(EnergyWatch, LossesFadeWhereAirDrags) {
  EnergyWatch watch(1, 1, 1, 0.5);  // e^-1 is left after a second
  watch.begin({});
  watch.after_step({.weight = -0.25}, 0, false, 1);
  watch.after_step({.weight = -0.5}, 0, false, 1);
  EXPECT_DOUBLE_EQ(watch.loss(), 0.25 * (1 + std::exp(-1)) / (1 + 5e-7));
  watch.after_step({.weight = -0.5}, 0, false, 100);
  watch.after_step({.weight = -0.75}, 0, false, 1);
  EXPECT_DOUBLE_EQ(watch.loss(), 0.25 * (1 + std::exp(-1)) / (1 + 5e-7));
}

struct Row {
  const char* model;
  Method method;
};
const Row kRows[] = {{"mass_spring", Method::implicit_euler},
                     {"mass_spring", Method::predictor_corrector},
                     {"rigid_links", Method::implicit_euler},
                     {"super_helix", Method::implicit_euler}};

void PrintTo(const Row& row, std::ostream* out) {
  *out << row.model << " by " << row_of(row.method).id;
}

class EnergyOfModels : public testing::TestWithParam<Row> {
 protected:
  // Hair of ten elements, level, under gravity.
  EnergyOfModels() {
    spec_ = level(straight_hair(10, kLength), -Vector3d::UnitY());
    spec_.fibre.bend_factor = spec_.fibre.twist_factor = 1;
    description_.method = row_.method;
    description_.step = kStep;
  }

  Simulation simulation() const {
    Description description = description_;
    description.modelled = {{find_model(row_.model), spec_}};
    return Simulation(std::move(description));
  }

  double weight() const { return spec_.fibre.material.line_density() * kLength * kG * kLength; }
  static double energy_of(const Simulation& simulation) { return energy(simulation.body(0)); }

  // Moves the root to the frame that is turned by this angle about the vertical.
  static void lead(Simulation& simulation, double h, const Vector3d& velocity, double angle, double spin) {
    const Vector3d tangent(std::cos(angle), std::sin(angle), 0), up = Vector3d::UnitZ();
    simulation.set_root(0, {simulation.body(0).root_position() + h * velocity, tangent,
                            tangent.cross(up).normalized(), velocity, spin * up});
  }

  static void expect_balanced(const Simulation& simulation, double bound) {
    for (const Concern concern : {Concern::energy, Concern::contact_energy})
      EXPECT_LE(simulation.watch().worst(concern), bound) << "gained";
    EXPECT_LE(simulation.watch().worst(Concern::loss), bound) << "lost";
  }

  const Row row_ = GetParam();
  StrandSpec spec_;
  Description description_;
};

INSTANTIATE_TEST_SUITE_P(, EnergyOfModels, testing::ValuesIn(kRows), [](const auto& row) {
  return std::string(row.param.model) + "_" + row_of(row.param.method).id;
});

// A root that is shaken at 2 m/s gives the strand its energy. The method's own error is of order one: it
// halves with the step.
TEST_P(EnergyOfModels, AShakenRootGivesNoGain) {
  spec_.fibre.bend_factor = 10;
  if (row_.model != std::string("mass_spring")) spec_.fibre.twist_factor = 10;
  const auto error = [&](double h) {
    description_.step = h;
    Simulation shaken = simulation();
    double most = 0;
    for (int k = 0; k * h < 0.1; ++k) {
      const double phase = 50 * k * h;
      lead(shaken, h, 2 * Vector3d(std::sin(phase), std::sin(2 * phase), std::sin(phase)), 0, 0);
      EXPECT_FALSE(shaken.step());
      most = std::max(most, energy_of(shaken));
    }
    EXPECT_GT(most, weight());
    EXPECT_LE(shaken.watch().worst(Concern::energy), kOrderOne);
    return shaken.watch().worst(Concern::energy) + shaken.watch().worst(Concern::loss);
  };
  const double coarse = error(kStep), fine = error(kStep / 2);
  EXPECT_GT(coarse, 1e-3);
  EXPECT_LE(fine, 0.6 * coarse);  // order one has 0.5, order one half 0.71
}

// The balance is the same in a moving frame.
TEST_P(EnergyOfModels, AreTheSameInAFrameThatMoves) {
  description_.step = 1.0 / 240;
  const auto books = [&](const Vector3d& velocity) {
    Simulation moving = simulation();
    BodyState state(moving.body(0));
    // All particles move, or the root with everything that hangs on it.
    const Eigen::Index moved = row_.model == std::string("mass_spring") ? state.rate.size() / 3 : 1;
    state.rate.head(3 * moved) = velocity.replicate(moved, 1);
    moving.body(0).write(state.q, state.rate);
    EXPECT_FALSE(moving.advance(40));
    return std::array{moving.watch().worst(Concern::energy), moving.watch().worst(Concern::loss),
                      moving.watch().worst(Concern::unmoved)};
  };
  const auto at_rest = books(Vector3d::Zero()), moving = books(Vector3d(1, -2, 0.5));
  EXPECT_GT(at_rest[0] + at_rest[1], 1e-3);
  // Solves end at 1e-10 of their right-hand sides, in each of 40 steps.
  for (std::size_t i = 0; i < at_rest.size(); ++i) EXPECT_NEAR(moving[i], at_rest[i], 1e-8);
}

TEST_P(EnergyOfModels, WindAndAFrameThatTurnsGiveNoGain) {
  description_.drag = 1e-3;
  description_.wind = Vector3d(0, 5, 0);
  Simulation turned = simulation();
  for (int k = 1; k <= 4000; ++k) {
    lead(turned, kStep, Vector3d::Zero(), 0.001 * k, 10);
    ASSERT_FALSE(turned.step());
  }
  EXPECT_LE(turned.watch().worst(Concern::energy), kOrderOne);
}

// Without weight a stiff strand that is turned faster and faster gets energy from its root alone.
TEST_P(EnergyOfModels, ARootThatSpinsUpGivesNoGain) {
  spec_.fibre.bend_factor = 100;
  if (row_.model != std::string("mass_spring")) spec_.fibre.twist_factor = 100;
  description_.gravity.setZero();
  Simulation spun = simulation();
  double angle = 0;
  for (int k = 1; k <= 4000; ++k) {
    const double spin = 0.005 * k;
    angle += kStep * spin;
    lead(spun, kStep, Vector3d::Zero(), angle, spin);
    ASSERT_FALSE(spun.step());
  }
  // A rod at 20 rad/s: m (L w)^2 / 6, which is 0.68 m g L.
  EXPECT_GT(energy_of(spun) / weight(), 0.6);
  EXPECT_LE(spun.watch().worst(Concern::energy), kOrderOne);
}

// A ball hits hair at 2 m/s: the energy of the fast part comes from the ball.
TEST_P(EnergyOfModels, AnObstacleGivesNoGain) {
  description_.obstacles = {{Sphere{Vector3d(0.07, -0.021, 0), 0.02}, 0.3, Vector3d(0, 2, 0)}};
  Simulation hit = simulation();
  ASSERT_FALSE(hit.advance(600));
  EXPECT_GT(hit.work().contacts, 5);
  const BodyState state(hit.body(0));
  EXPECT_GT(hit.body(0).measure(state.q, state.rate).kinetic, 0.15 * weight());
  EXPECT_LE(hit.watch().worst(Concern::energy), kOrderOne);
  EXPECT_LE(hit.watch().worst(Concern::contact_energy), kOrderOne);
}

// Without motion there are only rounding errors.
TEST_P(EnergyOfModels, RoundingIsNeither) {
  description_.gravity.setZero();
  description_.step = 1.0 / 240;
  spec_.root.axis = Vector3d(0.6, 0.8, 0);
  spec_.root.side = Vector3d::UnitZ();
  Simulation still = simulation();
  ASSERT_FALSE(still.advance(100));
  EXPECT_TRUE(still.watch().warnings().empty());
  expect_balanced(still, 1e-9);
}

// In thick air drag takes all energy, and this is no loss.
TEST_P(EnergyOfModels, DragTakesNoLoss) {
  description_.drag = 1e-2;
  Simulation slow = simulation();
  ASSERT_FALSE(slow.advance(1000));
  EXPECT_LT(energy_of(slow), -0.005 * weight());
  expect_balanced(slow, kOrderOne);
}

// Dampers take all energy, too.
TEST_P(EnergyOfModels, RelaxationTakesNoLoss) {
  if (row_.model == std::string("mass_spring")) GTEST_SKIP() << "masses and springs have no dampers";
  spec_.fibre.relaxation_time = 1;
  spec_.fibre.bend_factor = 1;
  Simulation slow = simulation();
  ASSERT_FALSE(slow.advance(1000));
  EXPECT_LT(energy_of(slow), 0);
  expect_balanced(slow, kOrderOne);
}

// In a second of falling and swinging, for steps that a picture needs and finer ones.
TEST_P(EnergyOfModels, ALossTellsHowFarOffPlacesAre) {
  if (row_.model == std::string("mass_spring") && row_.method == Method::implicit_euler)
    GTEST_SKIP() << "H4 loses the energy of stretching, too";
  const auto places = [&](int steps, double* lost) {
    description_.step = 1.0 / (60 * steps);
    Simulation fall = simulation();
    Eigen::MatrixXd x(3 * fall.body(0).points(), 60);
    for (int k = 0; k < 60; ++k) {
      EXPECT_FALSE(fall.advance(steps));
      x.col(k) = Line(fall.body(0)).x;
    }
    *lost = fall.watch().worst(Concern::loss);
    return x;
  };
  double lost = 0;
  const Eigen::MatrixXd fine = places(64, &lost);
  for (const int steps : {1, 2, 4, 8}) {
    const Eigen::MatrixXd off = places(steps, &lost) - fine;
    const double most =
        Eigen::Map<const Eigen::Matrix3Xd>(off.data(), 3, off.size() / 3).colwise().norm().maxCoeff();
    EXPECT_NEAR(std::log(kOffByLoss * lost / (most / kLength)), 0, std::log(3)) << lost << ", " << most;
  }
}

// A strand that the caller moves between two steps starts a new balance; a strand that is not watched has
// none.
TEST_P(EnergyOfModels, BeginAnewWithAnotherState) {
  Simulation thrown = simulation();
  ASSERT_FALSE(thrown.advance(10));
  BodyState state(thrown.body(0));
  state.rate.tail<3>() += Vector3d(0, 10, 0);
  thrown.body(0).write(state.q, state.rate);
  ASSERT_FALSE(thrown.advance(1));
  EXPECT_LE(thrown.watch().worst(Concern::energy), kOrderOne);

  description_.gravity *= 1e5;
  description_.step = 1.0 / 240;
  Simulation watched = simulation();
  watched.advance(20);
  EXPECT_FALSE(watched.watch().warnings().empty());
  description_.watched = false;
  Simulation unwatched = simulation();
  unwatched.advance(20);
  EXPECT_TRUE(unwatched.watch().warnings().empty());
  EXPECT_EQ(BodyState(watched.body(0)).q, BodyState(unwatched.body(0)).q);
}

}  // namespace
}  // namespace hair
