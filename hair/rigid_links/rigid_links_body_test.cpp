// STAFF ONLY. Strands of rigid links, in addition to the common properties of bodies
// (hair/simulation/bodies_test.cpp): hair that hangs, twists and lies on a table.
#include "hair/rigid_links/rigid_links_body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <numbers>

#include "hair/strand/test_bodies.h"

namespace hair {
namespace {

using Eigen::VectorXd;

// Strand and weight.
struct Setting {
  Vector3d gravity = Vector3d(0, 0, -9.81);
  double drag = 0;
  TreeStep method = &TreeSteps::linearly_implicit_euler;
};

std::unique_ptr<RigidLinksBody> body(const StrandSpec& spec, const Setting& setting = {}) {
  LinkStrand strand = link_strand(spec);
  strand.forces.gravity = setting.gravity;
  strand.forces.drag = setting.drag;
  return std::make_unique<RigidLinksBody>(std::move(strand), spec.root_velocity, setting.method);
}

// Explicit and implicit steps end at the same place if steps are small, and keep energy to their order.
TEST(RigidLinksBody, StepsAgreeWhenTheyAreSmall) {
  StrandSpec spec = straight_hair(4, 0.05);
  spec.start = {true, Vector3d(1, 0, 0)};
  spec.fibre.bend_factor = spec.fibre.twist_factor = 1e-3;
  const double time = 0.02, h = 1e-6;
  const auto exact = body(spec, {.method = &TreeSteps::runge_kutta_4});
  const double before = energy(*exact);
  advance(*exact, h, static_cast<int>(time / h));
  EXPECT_NEAR(energy(*exact), before, 1e-9 * std::abs(before));  // and rounding, 1e-16 in each of 2e4 steps
  const VectorXd x = Line(*exact).x;
  for (const TreeStep method : {&TreeSteps::symplectic_euler, &TreeSteps::linearly_implicit_euler}) {
    double errors[2];
    for (const int fine : {0, 1}) {
      const auto strand = body(spec, {.method = method});
      advance(*strand, h / (1 << fine), static_cast<int>(time / h) << fine);
      errors[fine] = (Line(*strand).x - x).norm();
    }
    EXPECT_NEAR(std::log2(errors[0] / errors[1]), 1, 0.1) << errors[0];
  }
}

// In the frame of an accelerating root, the strand has an additional weight. It comes to rest under the
// sum of the two.
TEST(RigidLinksBody, ARootThatAcceleratesAddsToTheWeight) {
  const double a = 9.81, h = 1e-3;
  StrandSpec spec = straight_hair(8);
  spec.root.axis = Vector3d(0, 0, -1);
  const auto still = body(spec, {Vector3d(-a, 0, -9.81), 1e-3}), pulled = body(spec, {.drag = 0});
  LinkStrand strand = link_strand(spec);
  // Drag would act against the air; both fall freely for a short time instead.
  const auto free = body(spec, {Vector3d(-a, 0, -9.81), 0});
  Eigen::MatrixXd scratch(0, 0);
  Work work;
  Vector3d position = Vector3d::Zero(), velocity = Vector3d::Zero();
  for (int k = 0; k < 30; ++k) {
    velocity += h * a * Vector3d::UnitX();
    position += h * velocity;
    pulled->set_root({position, Vector3d(0, 0, -1), Vector3d(1, 0, 0), velocity, Vector3d::Zero()});
    ASSERT_FALSE(pulled->step({h, 1e-10, {}, {}}, scratch, work));
    ASSERT_FALSE(free->step({h, 1e-10, {}, {}}, scratch, work));
  }
  VectorXd seen = Line(*pulled).x;
  for (int i = 0; i < pulled->points(); ++i) seen.segment<3>(3 * i) -= position;
  EXPECT_LE((seen - Line(*free).x).norm(), 1e-9);
}

// A hair with steps of a sixtieth of a second, where explicit methods need 1e-6 s: from horizontal to
// hanging.
TEST(RigidLinksBody, ASixtiethOfASecondHolds) {
  for (const int elements : {10, 100, 1000}) {
    StrandSpec spec = straight_hair(elements);
    spec.start = {true, Vector3d(1, 0, 0)};
    const auto strand = body(spec, {.drag = 2e-4});
    const double start = energy(*strand);
    double most = start;
    for (int k = 0; k < 600; ++k) {
      advance(*strand, 1.0 / 60, 1);
      most = std::max(most, energy(*strand));
    }
    EXPECT_LE(most - start, 1e-9 * std::abs(start)) << elements;
    EXPECT_LE((Vector3d(Line(*strand).x.tail<3>()) - Vector3d(0, 0, -0.1)).norm(), 1e-3) << elements;
  }
}

// A motion of hair of one link per cm, from level at rest, for 1.5 s.
struct Played {
  const char* name;
  bool clamped = true;
  std::optional<double> limit = {};
  // The root's path, m (a hand moves it by 1 m/s), and its turn about z, rad.
  Vector3d (*at)(double t) = [](double) { return Vector3d(0, 0, 0); };
  double (*turn)(double t) = [](double) { return 0.0; };
};

double smooth(double s) {
  s = std::clamp(s, 0.0, 1.0);
  return s * s * (3 - 2 * s);
}
double quarter_turn(double t) {
  return std::numbers::pi / 2 * smooth((t - 0.2) / 0.15);
}
Vector3d on_a_head(double t) {
  return 0.1 * Vector3d(std::cos(quarter_turn(t)), std::sin(quarter_turn(t)), 0);
}
Vector3d by_hand(double t) {
  return smooth(t / 0.1) *
         Vector3d(0.05 * std::sin(20 * t), 0.04 * std::sin(10 * t), 0.03 * std::sin(20 * t));
}

const Played kPlayed[] = {{"let go"},
                          {"pushed", false},
                          {"shaken", true, {}, by_hand},
                          {"turned", true, {}, on_a_head, quarter_turn},
                          {"limited to 20 degrees", true, 0.35},
                          {"turned, limited to 5 degrees", true, 0.087, on_a_head, quarter_turn},
                          {"shaken, limited to 2 degrees", true, 0.035, by_hand},
                          {"limited to 1 degree", true, 0.0175}};

struct PlayedHair {
  std::unique_ptr<RigidLinksBody> body;
  Work work;
  bool held = true;
  double gain = 0;

  PlayedHair(const Played& played, double length, double h, double time = 1.5) {
    StrandSpec spec = straight_hair(static_cast<int>(std::lround(100 * length)), length);
    spec.root = {played.at(0), Vector3d::UnitX(), -Vector3d::UnitY()};
    spec.clamped = played.clamped;
    spec.fibre.joint_limit = played.limit;
    if (!played.clamped) spec.start = {true, Vector3d::UnitX(), 1, false, Vector3d(0, 0, 1)};
    LinkStrand strand = link_strand(spec);
    strand.forces.gravity = Vector3d(0, 0, -9.81);
    const Matrix3d axes = strand.base.orientation.toRotationMatrix();
    body = std::make_unique<RigidLinksBody>(std::move(strand), Vector3d::Zero(),
                                            &TreeSteps::linearly_implicit_euler, true);
    Eigen::MatrixXd scratch(0, 0);
    for (int k = 1; held && k * h < time + h / 2; ++k) {
      const double t = k * h, angle = played.turn(t), before = played.turn(t - h);
      const Matrix3d now = turn_by(angle * Vector3d::UnitZ()) * axes;
      body->set_root({played.at(t), now.col(2), now.col(0), (played.at(t) - played.at(t - h)) / h,
                      (angle - before) / h * Vector3d::UnitZ()});
      held = !body->step({h, 1e-10, {}, {}}, scratch, work);
    }
    gain = body->sizes()[Concern::energy];
  }
};

// Hair holds at the steps that it is played with, and gains at most 0.03 of all its energy.
TEST(RigidLinksBody, HoldsAndGainsNothingAtAnyPlayedStep) {
  for (const Played& played : kPlayed) {
    double most = 0;
    for (const double length : {0.15, 0.3, 1.0})
      for (const double rate : {60, 240, 960, 3840}) {
        const PlayedHair hair(played, length, 1 / rate);
        most = std::max(most, hair.gain);
        EXPECT_TRUE(hair.held) << played.name << ", " << length << " m, 1/" << rate << " s";
        EXPECT_LE(hair.gain, 0.03) << played.name << ", " << length << " m, 1/" << rate << " s";
      }
    std::cout << played.name << ": gains at most " << most << "\n";
  }
}

// Steps that hold without momenta don't use them: the error is of order one, and does not grow where momenta
// begin.
TEST(RigidLinksBody, AFinerStepIsNeverWorse) {
  for (const double length : {0.2, 0.3, 0.6, 1.0}) {
    const VectorXd exact = Line(*PlayedHair(kPlayed[0], length, 1 / 15360.0, 0.5).body).x;
    double before = length;
    for (const double rate : {60, 120, 240, 480, 960, 1920}) {
      const PlayedHair hair(kPlayed[0], length, 1 / rate, 0.5);
      const double error = (Line(*hair.body).x - exact).norm();
      EXPECT_LT(error, before) << length << " m, 1/" << rate << " s";
      before = error;
    }
  }
  EXPECT_EQ(PlayedHair(kPlayed[0], 0.15, 1 / 960.0, 0.5).work.kept_steps, 0);
  EXPECT_GT(PlayedHair(kPlayed[0], 1, 1 / 240.0, 0.5).work.kept_steps, 0);
}

// A free rod turns by 0.1 rad in each step: momenta would take all its energy.
TEST(RigidLinksBody, AFreeSpinKeepsItsEnergy) {
  StrandSpec spec = straight_hair(20, 0.2);
  spec.clamped = false;
  spec.start = {true, Vector3d::UnitX(), 1, false, Vector3d(0, 0, 25)};
  const auto strand = body(spec, {Vector3d::Zero()});
  const double start = energy(*strand);
  advance(*strand, 1.0 / 240, 360);
  EXPECT_NEAR(energy(*strand), start, 1e-9 * start);
}

// Explicit weight would hold 0.93 m of hanging hair at 1/60 s (hair/rigid_links/link_momenta.h).
TEST(RigidLinksBody, AnyLengthHangsStill) {
  for (const double length : {0.9, 1.9}) {
    StrandSpec spec = straight_hair(200, length);
    spec.start = {true, Vector3d(1e-3, 0, -1).normalized()};
    const auto strand = body(spec);
    advance(*strand, 1.0 / 60, 1000);
    // A thousandth of its length as the height of fall, times sqrt(g / L) and the mode: about 3 mm/s.
    EXPECT_LE(Line(*strand).v.cwiseAbs().maxCoeff(), 0.01) << length;
  }
}

// Hair at rest has no tiny numbers left, which would slow each step tenfold.
TEST(RigidLinksBody, ComesToRestForGood) {
  StrandSpec spec = straight_hair(10);
  spec.start = {true, Vector3d(1, 0, 0)};
  const auto strand = body(spec, {.drag = 2e-4});
  advance(*strand, 1.0 / 60, 20000);
  for (const double v : Line(*strand).v) EXPECT_TRUE(v == 0 || std::abs(v) > 1e-200) << v;
}

// GJ phi'^2 / 2 and EI kappa^2 / 2 per metre, except for the last half of a rod, which nothing bends.
TEST(RigidLinksBody, ATwistAndAnArcHaveTheContinuumsEnergy) {
  StrandSpec spec = straight_hair(20);
  spec.fibre.twist_factor = 0.7;
  const Material& material = spec.fibre.material;
  const auto strand = body(spec, {Vector3d::Zero()});
  const double l = spec.length / spec.elements, bent = spec.length - l / 2, rate = 15;  // rad/m
  for (const auto& [axis, rigidity] : {std::pair{Vector3d(0, 0, -1), 0.7 * material.twist_rigidity()},
                                       std::pair{Vector3d(0, 1, 0), material.bend_rigidity()}}) {
    BodyState state(*strand);
    for (int i = 1; i <= spec.elements; ++i) state.q.segment<3>(3 * i) = rate * (i - 0.5) * l * axis;
    EXPECT_NEAR(strand->measure(state.q, state.rate).potential, rigidity * rate * rate * bent / 2,
                1e-12 * rigidity * rate * rate);
  }
}

// One rod on the spring of its root, twisted: J phi'' = -2 GJ/l (phi + tau phi').
TEST(RigidLinksBody, RelaxationDampsATwistAsItsClosedFormSays) {
  StrandSpec spec = straight_hair(1, 0.01);
  const Material& material = spec.fibre.material;
  const double k = 2 * material.twist_rigidity() / spec.length;
  const double J = material.line_density() * spec.length * material.radius * material.radius / 2;
  const double omega = std::sqrt(k / J), share = 0.2, start = 0.5;
  spec.fibre.relaxation_time = 2 * share / omega;
  const auto strand = body(spec, {Vector3d::Zero(), 0, &TreeSteps::runge_kutta_4});
  BodyState state(*strand);
  state.q[5] = start;
  strand->write(state.q, state.rate);
  const int steps = 400;
  const double time = 4 / omega, damped = omega * std::sqrt(1 - share * share);
  advance(*strand, time / steps, steps);
  const double expected = start * std::exp(-share * omega * time) *
                          (std::cos(damped * time) + share * omega / damped * std::sin(damped * time));
  EXPECT_NEAR(BodyState(*strand).q[5], expected, 1e-9 * start);  // (omega h)^4 / 120 a step
}

// A limit stops a hair whose weight would fold it at its root.
TEST(RigidLinksBody, NoJointTurnsBeyondItsLimit) {
  StrandSpec spec = level(straight_hair(20, 0.2));
  spec.fibre.bend_factor = spec.fibre.twist_factor = 0.01;
  spec.fibre.joint_limit = 0.1;
  const auto strand = body(spec, {.drag = 1e-4});
  advance(*strand, 1.0 / 60, 600);
  const Line line(*strand);
  double largest = 0;
  Vector3d before = spec.root.axis;
  for (int i = 0; i < spec.elements; ++i) {
    const Vector3d rod = (line.x.segment<3>(3 * i + 3) - line.x.segment<3>(3 * i)).normalized();
    largest = std::max(largest, std::atan2(before.cross(rod).norm(), before.dot(rod)));
    before = rod;
  }
  // The whole weight at half of the length, against the buffer.
  const Material& material = spec.fibre.material;
  const double moment = material.line_density() * 9.81 * spec.length * spec.length / 2;
  EXPECT_LE(largest,
            0.1 + moment / (kLimitFactor * material.bend_rigidity() / (spec.length / spec.elements)));
  EXPECT_GE(largest, 0.1) << "nothing meets a limit";
}

// One rod lies on a table and turns about its root. For any distribution of its weight, friction's moment is
// mu m g l / 2, against m l^2 / 3: it slows by 3/2 mu g / l.
TEST(RigidLinksBody, FrictionSlowsARodOnATable) {
  const double l = 0.02, mu = 0.3, speed = 20, h = 1e-4;
  const std::vector<Obstacle> table = {{Plane{Vector3d(0, 0, 0), Vector3d(0, 0, 1)}, mu}};
  StrandSpec spec = level(straight_hair(1, l));
  spec.clamped = false;
  spec.start = {true, Vector3d(1, 0, 0), 1, false, Vector3d(0, 0, speed)};
  const auto rate = [](const Body& one) { return BodyState(one).rate[5]; };
  const double slowing = 1.5 * mu * 9.81 / l;
  const auto strand = body(spec);
  const int steps = static_cast<int>(0.5 * speed / slowing / h);
  advance(*strand, h, steps, {}, table);
  // The first step has no friction yet; each step divides the rate by 1 + h slowing / rate.
  EXPECT_NEAR(rate(*strand), speed - slowing * h * steps, 3 * h * slowing);
  advance(*strand, h, 3 * steps, {}, table);
  EXPECT_LE(std::abs(rate(*strand)), kCreep / l);
  // A push across it below mu m g / 2 at its tip moves it only by creep, and a larger one moves it.
  const double weight = spec.fibre.material.line_density() * l * 9.81;
  const auto tip = [&] { return Vector3d(Line(*strand).x.tail<3>()); };
  const auto pushed = [&](double part) {
    const Vector3d at = tip(), across = Vector3d(-at.y(), at.x(), 0) / l;
    const PointForce push{1, part * mu * weight * across, Eigen::Matrix3d::Zero()};
    advance(*strand, h, 1000, {&push, 1}, table);
    return (tip() - at).norm();
  };
  EXPECT_LE(pushed(0.4), 2 * kCreep * 1000 * h);
  EXPECT_GT(pushed(0.6), 1e-3);
}

// A moving obstacle takes hair on it along.
TEST(RigidLinksBody, AMovingTableDragsItsHair) {
  std::vector<Obstacle> table = {{Plane{Vector3d(0, 0, 0), Vector3d(0, 0, 1)}, 0.5, Vector3d(0, 0.02, 0)}};
  StrandSpec spec = level(straight_hair(1, 0.02));
  spec.clamped = false;
  const auto strand = body(spec);
  advance(*strand, 1e-3, 400, {}, table);
  EXPECT_GT(Line(*strand).x[4], 1e-3);
}

}  // namespace
}  // namespace hair
