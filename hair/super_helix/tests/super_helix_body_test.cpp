// STAFF ONLY. Strands that are super-helices: what a body promises, and hair that rests, hangs, coils and meets obstacles.
#include "hair/super_helix/super_helix_body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "hair/lab/validate/elastica.h"
#include "hair/simulation/models.h"
#include "hair/strand/centre_line.h"
#include "hair/strand/tests/bodies.h"
#include "hair/strand/tests/placed_ball.h"
#include "hair/strand/turns.h"
#include "solver/tests/allocations.h"

namespace hair {
namespace {

using Eigen::VectorXd;

std::unique_ptr<SuperHelixBody> body(const StrandSpec& spec,
                                     HelixSurroundings surroundings = {Vector3d(0, 0, -9.81)}) {
  surroundings.relaxation_time = spec.fibre.relaxation_time;
  return std::make_unique<SuperHelixBody>(helix_start(spec), surroundings, spec.root_velocity);
}

// A helix is exact with any number of elements, also with turns that segments could not follow.
TEST(SuperHelixBody, StartsOnItsRestShape) {
  for (const int elements : {1, 2, 5, 40}) {
    StrandSpec fine = curl(elements);
    const auto strand = body(fine);
    const VectorXd at = strand->arc_lengths(), x = Line(*strand).x;
    fine.elements = 480;
    const RestShape shape = rest_shape(fine);
    const VectorXd fine_at = VectorXd::LinSpaced(481, 0, fine.length);
    // Between the shape's points, a quarter of a millimetre apart, the curve leaves its chord by k l^2 / 8.
    EXPECT_LE((points_at(shape.x, fine_at, at) - x).lpNorm<Eigen::Infinity>(), 200 * 6.25e-8 / 8) << elements;
    EXPECT_EQ(Line(*strand).v.norm(), 0);
  }
}

// Of a wave each element has the mean curvature: it turns as the wave does, and ends near it, to the second order.
TEST(SuperHelixBody, FollowsAWaveToTheSecondOrder) {
  StrandSpec spec = straight_hair(20, 0.12);
  spec.form = Wavy{0.003, 0.04};
  double off[2];
  for (const int fine : {0, 1}) {
    spec.elements = 24 << fine;
    const Vector3d exact = rest_shape(spec).x.tail<3>();
    off[fine] = (tip(*body(spec)) - exact).norm();
  }
  EXPECT_NEAR(std::log2(off[0] / off[1]), 2, 0.3) << off[0] << ", " << off[1];
}

TEST(SuperHelixBody, RestsWithoutWeight) {
  const auto strand = body(curl(5), {});
  const VectorXd x = Line(*strand).x;
  advance(*strand, 1.0 / 60, 600);
  EXPECT_LE((Line(*strand).x - x).norm(), 1e-12);
}

TEST(SuperHelixBody, WhatIsWrittenIsReadAndMovesOnAsBefore) {
  const auto one = body(curl(4)), other = body(curl(4));
  const Root root{Vector3d(0.01, 0, 0), Vector3d(0.6, 0, -0.8), Vector3d(0.8, 0, 0.6), Vector3d(1, 0, 0),
                  Vector3d(0, 6, 0)};
  one->set_root(root);
  advance(*one, 1e-3, 50);
  const BodyState state(*one);
  other->write(state.q, state.rate);
  const BodyState again(*other);
  EXPECT_LE((again.q - state.q).norm(), 1e-12 * state.q.norm());
  EXPECT_LE((again.rate - state.rate).norm(), 1e-12 * state.rate.norm());
  advance(*one, 1e-3, 20);
  advance(*other, 1e-3, 20);
  // A state has no momenta of the step before; what starts from it takes accelerations, which are as good to the order of h^2.
  EXPECT_LE((Line(*one).x - Line(*other).x).norm(), 1e-4);
  const BodyMeasures measures = one->measure(BodyState(*one).q, BodyState(*one).rate);
  EXPECT_LE((*measures.tip - tip(*one)).norm(), 1e-15);
}

TEST(SuperHelixBody, VelocitiesAreThoseOfTheLine) {
  const auto strand = body(curl(4));
  advance(*strand, 1e-3, 40);
  const double h = 1e-6;
  const Line now(*strand);
  advance(*strand, h, 1);
  const Line then(*strand);
  EXPECT_LE(((then.x - now.x) / h - then.v).norm(), 1e-3 * then.v.norm());
}

// A root that turns and moves takes a stiff strand along, as a rigid body.
TEST(SuperHelixBody, FollowsItsRoot) {
  StrandSpec spec = curl(3);
  spec.fibre.bend_factor = spec.fibre.twist_factor = 1e6;
  const auto strand = body(spec, {});
  const VectorXd x = Line(*strand).x;
  const RestShape shape = root_of_curve(spec);
  const double h = 1e-3;
  const int steps = 500;
  const Vector3d velocity(0.1, -0.2, 0.05), spin(0, 0, 2);
  Eigen::Quaterniond turned = Eigen::Quaterniond::Identity();
  for (int k = 1; k <= steps; ++k) {
    turned = turn_by(k * h * spin);
    strand->set_root({k * h * velocity, turned * shape.tangent, turned * shape.normal, velocity, spin});
    advance(*strand, h, 1);
  }
  const VectorXd after = Line(*strand).x;
  for (int i = 0; i < strand->points(); ++i)
    EXPECT_LE((after.segment<3>(3 * i) - (steps * h * velocity + turned * x.segment<3>(3 * i))).norm(), 1e-6);
  EXPECT_EQ(strand->root_position(), steps * h * velocity);
}

// Overdamped, what is bent returns like exp(-t / tau).
TEST(SuperHelixBody, RelaxationSlowsTheReturn) {
  StrandSpec spec = straight_hair(1, 0.05);
  spec.fibre.relaxation_time = 2;
  const auto strand = body(spec, {});
  BodyState state(*strand);
  state.q[6] = 5;
  strand->write(state.q, state.rate);
  advance(*strand, 1e-3, 2000);
  EXPECT_NEAR(BodyState(*strand).q[6], 5 / std::numbers::e, 0.01 * 5);
}

// The heavy elastica from a horizontal clamp; more elements are nearer, to the second order.
TEST(SuperHelixBody, HangsAsTheElastica) {
  for (const double gamma : {1.0, 10.0, 100.0}) {
    StrandSpec spec = straight_hair(4);
    spec.root.axis = Vector3d(1, 0, 0);
    spec.root.side = Vector3d(0, 0, 1);
    const Material& material = spec.fibre.material;
    const double L = spec.length,
                 g = gamma * material.bend_rigidity() / (material.line_density() * L * L * L);
    const Eigen::Vector2d exact = L * elastica(gamma).tip();
    double errors[2];
    for (const int fine : {0, 1}) {
      spec.elements = 8 << fine;
      const auto strand = body(spec, {Vector3d(0, 0, -g)});
      // At rest after each step, a step goes down the energy; weight is explicit, and holds for so long steps.
      const double h = std::sqrt(material.bend_rigidity() / material.line_density()) / (L * g);
      Vector3d before;
      int steps = 0;
      do {
        before = tip(*strand);
        advance(*strand, h, 1);
        const BodyState state(*strand);
        strand->write(state.q, VectorXd::Zero(state.q.size()));
      } while ((tip(*strand) - before).norm() > 1e-12 * L && ++steps < 20000);
      errors[fine] = (Eigen::Vector2d(tip(*strand).x(), -tip(*strand).z()) - exact).norm();
    }
    EXPECT_LE(errors[1], 0.01 * L) << gamma;
    EXPECT_GE(errors[0] / errors[1], 3) << gamma << ": " << errors[0] / L << ", " << errors[1] / L;
  }
}

// Drag takes energy away, and nothing else gives any.
TEST(SuperHelixBody, DragTakesEnergy) {
  const auto strand = body(curl(5), {Vector3d(0, 0, -9.81), 2e-4});
  double before = energy(*strand);
  for (int k = 0; k < 200; ++k) {
    advance(*strand, 1e-3, 1);
    const double now = energy(*strand);
    EXPECT_LE(now, before + 1e-12);
    before = now;
  }
}

TEST(SuperHelixBody, ImplicitStepsFeelPointForces) {
  const auto strand = body(straight_hair(5), {});
  const int last = strand->points() - 1;
  const PointForce spring{last, Vector3d(1e-6, 0, 0), 1e6 * Eigen::Matrix3d::Identity()};
  const double before = tip(*strand).x();
  advance(*strand, 1.0 / 60, 1, {&spring, 1});
  // Such a stiffness holds the point: a step moves it by what the force is over the stiffness.
  EXPECT_LE(std::abs(tip(*strand).x() - before), 1e-11);
  const PointForce pull{last, Vector3d(1e-6, 0, 0), Eigen::Matrix3d::Zero()};
  advance(*strand, 1.0 / 60, 5, {&pull, 1});
  EXPECT_GT(tip(*strand).x() - before, 1e-3);
}

// A hair that falls on a ball rests on it or hangs beside it, at a sixtieth of a second.
TEST(SuperHelixBody, StaysOutOfABall) {
  const Vector3d middle(0.06, 0, -0.04);
  for (const Obstacle& one : {Obstacle{Sphere{middle, 0.03}}, Obstacle{Sphere{middle, 0.03}, 0.5},
                              placed_ball(middle, 0.03, 0.5)}) {
    const std::vector<Obstacle> ball = {one};
    const double friction = one.friction;
    StrandSpec spec = straight_hair(10, 0.15);
    spec.root.axis = Vector3d(1, 0, 0);
    spec.root.side = Vector3d(0, 0, 1);
    const auto strand = body(spec, {Vector3d(0, 0, -9.81), 2e-4});
    advance(*strand, 1.0 / 60, 600, {}, ball);
    const VectorXd x = Line(*strand).x;
    double nearest = 1;
    for (int i = 0; i < strand->points(); ++i)
      nearest = std::min(nearest, (x.segment<3>(3 * i) - middle).norm() - 0.03);
    EXPECT_GE(nearest, -kRestingDepth) << friction;
    EXPECT_LE(nearest, 1e-4) << "it does not touch";
  }
}

// Kirchhoff's rod by two models that share nothing but its constants. Where a level curl sags, it bends to and fro with each turn, so
// that an element should be a small part of a turn.
TEST(SuperHelixBody, FallsAsRigidLinksDo) {
  StrandSpec spec = curl(24);
  spec.root.axis = Vector3d(1, 0, 0);
  spec.root.side = Vector3d(0, 0, 1);
  const auto helices = body(spec);
  spec.elements = 96;
  Description description;
  description.method = Method::implicit_euler;
  const std::unique_ptr<Body> links = find_model("rigid_links")->make(spec, description);
  const Vector3d start = tip(*helices);
  advance(*helices, 1e-4, 1000);
  advance(*links, 1e-4, 1000);
  const double moved = (tip(*helices) - start).norm();
  EXPECT_GT(moved, 0.01);
  EXPECT_LE((tip(*helices) - tip(*links)).norm(), 0.03 * moved);
}

TEST(SuperHelixBody, AllocatesNothing) {
  const auto strand = body(curl(4), {Vector3d(0, 0, -9.81), 1e-4});
  const std::vector<Obstacle> floor = {{Plane{Vector3d(0, 0, -0.05), Vector3d(0, 0, 1)}, 0.5}};
  Eigen::MatrixXd scratch(strand->scratch_rows(), strand->scratch_columns());
  Work work;
  strand->step({1e-3, 1e-10, floor, {}}, scratch, work);
  const long before = reference_tests::allocations();
  for (int k = 0; k < 10; ++k) strand->step({1e-3, 1e-10, floor, {}}, scratch, work);
  EXPECT_EQ(reference_tests::allocations(), before);
}

TEST(SuperHelixBody, ADrawnStrandRestsNearItsPoints) {
  StrandSpec spec = curl(48);
  const RestShape shape = rest_shape(spec);
  spec.form = Drawn{shape.x};
  spec.length = 0;
  for (int i = 0; i < spec.elements; ++i)
    spec.length += (shape.x.segment<3>(3 * i + 3) - shape.x.segment<3>(3 * i)).norm();
  const auto strand = body(spec);
  // Of the second order in a piece's angle, 0.2 rad: 1 % of the length.
  EXPECT_LE((tip(*strand) - Vector3d(shape.x.tail<3>())).norm(), 0.02 * spec.length);
}

TEST(SuperHelixBody, SaysWhatItCannotExpress) {
  const auto why = [](auto change) {
    StrandSpec spec = curl(3);
    change(spec);
    return why_not_of_helices(spec);
  };
  EXPECT_EQ(why([](StrandSpec&) {}), "");
  EXPECT_EQ(why([](StrandSpec& one) { one.fibre.skip_factor = 0.1; }),
            "super-helices have no springs that skip a particle; the skip_factor must be 0");
  EXPECT_EQ(why([](StrandSpec& one) { one.fibre.stretch_factor = 0.5; }),
            "super-helices don't stretch; the stretch_factor must be at least 1");
  EXPECT_EQ(why([](StrandSpec& one) { one.fibre.bend_factor = 0; }),
            "super-helices resist bends and twists; the bend_factor and the twist_factor must be above 0");
  EXPECT_EQ(why([](StrandSpec& one) { one.fibre.joint_limit = 1; }),
            "super-helices have no joints; leave the joint_limit out");
  EXPECT_EQ(why([](StrandSpec& one) { one.clamped = false; }), "super-helices must be clamped");
  EXPECT_EQ(why([](StrandSpec& one) { one.elements = 401; }),
            "super-helices have at most 400 elements; each bends and twists, so that few are enough");
  EXPECT_EQ(why([](StrandSpec& one) {
              one.form = Curly{0.001, 0.001}, one.length = 1;
            }),
            "elements of super-helices wind up to 20 times; give the strand more of them");
  EXPECT_EQ(why([](StrandSpec& one) {
              one.start = {true, Vector3d(1, 0, 0)};
            }),
            "super-helices leave their roots along the roots' direction; give the start this direction, or "
            "leave it out");
  StrandSpec spec = curl(3);
  spec.clamped = false;
  EXPECT_THROW(helix_start(spec), std::invalid_argument);
}

}  // namespace
}  // namespace hair
