// STAFF ONLY. The promises of bodies of any model to their callers: a test is a property, a row is a model.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <ostream>

#include "hair/lab/validate/elastica.h"
#include "hair/obstacles/test_placed_ball.h"
#include "hair/simulation/models.h"
#include "hair/strand/implicit_contacts.h"
#include "hair/strand/measures.h"
#include "hair/strand/test_bodies.h"
#include "hair/strand/turns.h"
#include "solver/test_allocations.h"

namespace hair {
namespace {

using Eigen::VectorXd;

struct Surroundings {
  Vector3d gravity = Vector3d(0, 0, -9.81);
  double drag = 0;
  std::vector<Obstacle> obstacles = {};
};
constexpr double kThinAir = 2e-4;  // N s/m^2

struct Row {
  const char* model;
  std::vector<int> divisions;  // elements of a curl; the last one is used if one is enough
  double on_curve;             // m: the distance of a point from the rest curve at the start
  double at_rest;              // m: the motion of all points in ten seconds without weight
  double read_again;           // relative error of coordinates that are written and read
  double goes_on;              // m: the difference 20 ms after writing a state
  bool holds_its_root;         // the coordinates have the root's frame and motion
  bool starts_anyhow;          // it can be held in another direction than its root's, and hinged
  int in_a_fall;               // elements of a straight hair
  long allocations;            // in a step: ConjGrad of the reference has three vectors, and H4 three more
};

// Between the points of a finely divided curve, a quarter of a millimetre apart, the curve leaves its chord
// by k l^2 / 8.
constexpr double kChord = 200 * 6.25e-8 / 8;

// A state of super-helices does not contain the previous step's momenta. A body that starts from it uses
// accelerations, which are as good to the order of h^2.
const Row kRows[] = {
    {.model = "mass_spring",
     .divisions = {24, 48},
     .on_curve = 1e-13,
     .at_rest = 1e-9,
     .read_again = 0,
     .goes_on = 0,
     .holds_its_root = false,
     .starts_anyhow = true,
     .in_a_fall = 30,
     .allocations = 6},
    {.model = "rigid_links",
     .divisions = {24, 48},
     .on_curve = 1e-13,
     .at_rest = 1e-9,
     .read_again = 1e-12,
     .goes_on = 1e-9,
     .holds_its_root = false,
     .starts_anyhow = true,
     .in_a_fall = 30,
     .allocations = 0},
    {.model = "super_helix",
     .divisions = {1, 2, 40, 5},
     .on_curve = kChord,
     .at_rest = 1e-12,
     .read_again = 1e-12,
     .goes_on = 1e-4,
     .holds_its_root = true,
     .starts_anyhow = false,
     .in_a_fall = 10,
     .allocations = 0},
};

void PrintTo(const Row& row, std::ostream* out) {
  *out << row.model;
}

class Bodies : public testing::TestWithParam<Row> {
 protected:
  std::unique_ptr<Body> body(const StrandSpec& spec, const Surroundings& around = {}) const {
    Description description;
    description.method = Method::implicit_euler;
    description.gravity = around.gravity;
    description.drag = around.drag;
    description.obstacles = around.obstacles;
    description.point_forces = true;
    return find_model(row_.model)->make(spec, description);
  }
  StrandSpec curly() const { return curl(row_.divisions.back()); }

  const Row row_ = GetParam();
};

INSTANTIATE_TEST_SUITE_P(, Bodies, testing::ValuesIn(kRows),
                         [](const auto& row) { return std::string(row.param.model); });

TEST(TableOfBodies, HasARowForEachModel) {
  ASSERT_EQ(std::size(kRows), models().size());
  for (const Row& row : kRows) EXPECT_TRUE(find_model(row.model)) << row.model;
}

TEST_P(Bodies, StartAtRestOnTheirRestCurve) {
  for (const int elements : row_.divisions) {
    StrandSpec spec = curl(elements);
    const auto strand = body(spec);
    const Line line(*strand);
    VectorXd at = strand->arc_lengths();
    ASSERT_EQ(at.size(), strand->points());
    EXPECT_EQ(line.v.norm(), 0);
    // Segments are chords, shorter than the curve by (curvature length)^2 / 24 and terms of the fourth power.
    const double bent = bend_at(spec.form, 0).curvature * spec.length / elements, whole = at[at.size() - 1];
    EXPECT_LE(std::abs(whole / spec.length - 1), bent * bent / 24 + 1e-14);
    spec.elements = 480;
    at *= spec.length / whole;
    const VectorXd curve = points_at(rest_shape(spec).x, VectorXd::LinSpaced(481, 0, spec.length), at);
    EXPECT_LE((curve - line.x).lpNorm<Eigen::Infinity>(), row_.on_curve) << elements;
  }
}

// A helix has curvature and torsion; the strand holds both, and without weight it does not move.
TEST_P(Bodies, RestWithoutWeight) {
  const auto strand = body(curly(), {Vector3d::Zero()});
  const VectorXd x = Line(*strand).x;
  advance(*strand, 1.0 / 60, 600);
  EXPECT_LE((Line(*strand).x - x).norm(), row_.at_rest);
}

TEST_P(Bodies, AreHeldAsTheirStartSaysOrRefuseIt) {
  StrandSpec spec = curly();
  spec.start = {true, Vector3d(0.6, 0, 0.8), 1, false, Vector3d(3, 0, -2)};
  if (!row_.starts_anyhow) {
    EXPECT_NE(find_model(row_.model)->why_not(spec), "");
    EXPECT_THROW(body(spec), std::invalid_argument);
    return;
  }
  const auto strand = body(spec);
  const Line line(*strand);
  for (int i = 1; i < strand->points(); ++i) {
    const Vector3d arm = strand->arc_lengths()[i] * spec.start.direction;
    EXPECT_LE((line.x.segment<3>(3 * i) - arm).norm(), 1e-14);
    EXPECT_LE((line.v.segment<3>(3 * i) - spec.start.spin.cross(arm)).norm(), 1e-14);
  }
  spec.start.folded = true;
  spec.form = Straight{};
  EXPECT_LE(tip(*body(spec)).norm(), 1e-14);
}

TEST_P(Bodies, WhatIsWrittenIsReadAndMovesOnAsBefore) {
  const auto one = body(curly()), other = body(curly());
  const Root root{Vector3d(0.01, 0, 0), Vector3d(0.6, 0, -0.8), Vector3d(0.8, 0, 0.6), Vector3d(1, 0, 0),
                  Vector3d(0, 6, 0)};
  if (row_.holds_its_root) one->set_root(root);
  advance(*one, 1e-3, 50);
  const BodyState state(*one);
  other->write(state.q, state.rate);
  const BodyState again(*other);
  EXPECT_LE((again.q - state.q).norm(), row_.read_again * state.q.norm());
  EXPECT_LE((again.rate - state.rate).norm(), row_.read_again * state.rate.norm());
  EXPECT_EQ(other->root_position(), Vector3d(Line(*other).x.head<3>()));
  EXPECT_LE((*other->measure(state.q, state.rate).tip - tip(*other)).norm(), 1e-15);
  advance(*one, 1e-3, 20);
  advance(*other, 1e-3, 20);
  EXPECT_LE((Line(*one).x - Line(*other).x).norm(), row_.goes_on);
}

TEST_P(Bodies, VelocitiesAreThoseOfTheLine) {
  const auto strand = body(curly());
  advance(*strand, 1e-3, 40);
  const double h = 1e-6;
  const Line now(*strand);
  advance(*strand, h, 1);
  const Line then(*strand);
  EXPECT_GT(then.v.norm(), 0.01);
  EXPECT_LE(((then.x - now.x) / h - then.v).norm(), 1e-3 * then.v.norm());
}

// A root that turns by half a radian, and moves, takes the whole curl along: in air, it rests there later.
TEST_P(Bodies, FollowTheirRoot) {
  const StrandSpec spec = curly();
  const auto strand = body(spec, {.gravity = Vector3d::Zero(), .drag = 1e-3});
  const VectorXd x = Line(*strand).x;
  const RestShape shape = root_of_curve(spec);
  const double h = 1.0 / 240;
  const Vector3d velocity(0.1, -0.2, 0.05), spin = Vector3d(1, 2, 3).normalized();
  for (int k = 1; k <= 600; ++k) {
    const double time = h * std::min(k, 120), moves = k <= 120 ? 1 : 0;
    const Eigen::Quaterniond turned = turn_by(time * spin);
    strand->set_root(
        {time * velocity, turned * shape.tangent, turned * shape.normal, moves * velocity, moves * spin});
    advance(*strand, h, 1);
  }
  const Line after(*strand);
  for (int i = 0; i < strand->points(); ++i)
    EXPECT_LE(
        (after.x.segment<3>(3 * i) - (0.5 * velocity + turn_by(0.5 * spin) * x.segment<3>(3 * i))).norm(),
        0.01 * spec.length);
}

TEST_P(Bodies, ImplicitStepsFeelPointForces) {
  const auto strand = body(straight_hair(10), {Vector3d::Zero()});
  const int middle = strand->points() / 2, last = strand->points() - 1;
  const auto x_of = [&](int point) { return Line(*strand).x[3 * point]; };
  const PointForce forces[] = {
      {middle, Vector3d(1e-6, 0, 0), 1e6 * Eigen::Matrix3d::Identity()},
      {last, Vector3d(0, 0, -1e-5), Eigen::Matrix3d::Zero()},
  };
  const double before = x_of(middle);
  advance(*strand, 1.0 / 60, 1, forces);
  // Such a stiffness holds the point: a step moves it by the force over the stiffness.
  EXPECT_LE(std::abs(x_of(middle) - before), 1e-11);
  const PointForce pull{last, Vector3d(1e-6, 0, 0), Eigen::Matrix3d::Zero()};
  advance(*strand, 1.0 / 60, 5, {&pull, 1});
  EXPECT_GT(x_of(last), 1e-3);
}

// A hair that falls on a ball slides off and hangs beside it, or lies on it if it is clamped, with steps of a
// sixtieth of a second.
TEST_P(Bodies, StayOutOfABall) {
  const double radius = 0.03, h = 1.0 / 60;
  const Vector3d middle = row_.starts_anyhow ? Vector3d(0.05, 0, -0.05) : Vector3d(0.06, 0, -0.04);
  for (const Obstacle& one : {Obstacle{Sphere{middle, radius}}, Obstacle{Sphere{middle, radius}, 0.5},
                              placed_ball(middle, radius, 0.5)}) {
    StrandSpec spec = straight_hair(row_.in_a_fall, 0.15);
    spec.clamped = !row_.starts_anyhow;
    if (row_.starts_anyhow) {
      spec.start = {true, Vector3d(1, 0, 0)};
    } else {
      spec.root.axis = Vector3d(1, 0, 0);
      spec.root.side = Vector3d(0, 0, 1);
    }
    const std::vector<Obstacle> ball = {one};
    const auto strand = body(spec, {.drag = kThinAir, .obstacles = ball});
    Eigen::MatrixXd scratch(strand->scratch_rows(), strand->scratch_columns());
    double deepest = 0, left = 0;
    long contacts = 0;
    for (int k = 0; k < 660; ++k) {
      Work work;
      ASSERT_FALSE(strand->step({h, 1e-10, ball, {}}, scratch, work)) << "step " << k;
      contacts += work.contacts;
      (k < 600 ? deepest : left) = std::max(k < 600 ? deepest : left, work.penetration);
    }
    // At most, the weight of all points presses on one: m n g = k depth. A step cuts off a curved surface by
    // v^2 h^2 / 2r, with v = 1 m/s.
    EXPECT_LE(deepest, strand->points() * 9.81 / (kContactRate * kContactRate) + h * h / (2 * radius))
        << one.friction;
    EXPECT_LE(left, kRestingDepth) << one.friction;
    EXPECT_GT(contacts, 0) << one.friction;
    const VectorXd x = Line(*strand).x;
    double nearest = 1;
    for (int i = 0; i < strand->points(); ++i)
      nearest = std::min(nearest, (x.segment<3>(3 * i) - middle).norm() - radius);
    EXPECT_GE(nearest, -kRestingDepth) << one.friction;
    if (!row_.starts_anyhow) {
      EXPECT_LE(nearest, 1e-4) << "it does not touch";
    }
  }
}

TEST_P(Bodies, AllocateNothingInAStep) {
  const std::vector<Obstacle> floor = {{Plane{Vector3d(0, 0, -0.05), Vector3d(0, 0, 1)}, 0.5}};
  const auto strand = body(curly(), {.drag = 1e-4, .obstacles = floor});
  Eigen::MatrixXd scratch(strand->scratch_rows(), strand->scratch_columns());
  Work work;
  strand->step({1e-3, 1e-10, floor, {}}, scratch, work);
  const long before = reference_tests::allocations();
  for (int k = 0; k < 10; ++k) strand->step({1e-3, 1e-10, floor, {}}, scratch, work);
  EXPECT_EQ(reference_tests::allocations(), before + 10 * row_.allocations);
  EXPECT_GT(work.contacts, 0);
}

struct Load {
  double gamma;  // weight over bending stiffness
  int elements;  // and twice as many in a second run
};

struct Hanging {
  const char* model;
  std::vector<Load> loads;
  double step;     // s, times the weight over sqrt(EI rho A)
  double settled;  // over the length: the motion of a tip at rest in 20 steps
  double least_order, most_order;
};

// hair/rigid_links/tree_system.h: 2.8 is the longest step that decreases the energy.
const Hanging kHanging[] = {
    {"rigid_links", {{1, 10}, {10, 10}, {100, 20}, {1000, 50}, {3800, 80}}, 2, 1e-13, 1.8, 2.2},
    {"super_helix", {{1, 8}, {10, 8}, {100, 8}}, 1, 1e-12, 1.58, 2.5},
};

// The heavy elastica from a horizontal clamp. The strand is stopped after each step, so each step decreases
// the energy.
TEST(HangingBodies, HaveTheElasticasTipToTheSecondOrder) {
  for (const Hanging& row : kHanging)
    for (const auto& [gamma, elements] : row.loads) {
      StrandSpec spec = level(straight_hair(elements));
      const Material& material = spec.fibre.material;
      const double EI = material.bend_rigidity(), line = material.line_density(), L = spec.length;
      const double g = gamma * EI / (line * L * L * L), h = row.step * std::sqrt(EI * line) / (line * L * g);
      Description description;
      description.method = Method::implicit_euler;
      description.gravity = Vector3d(0, 0, -g);
      const Eigen::Vector2d exact = L * elastica(gamma).tip;
      double errors[2];
      for (const int fine : {0, 1}) {
        spec.elements = elements << fine;
        const auto strand = find_model(row.model)->make(spec, description);
        Vector3d before;
        int steps = 0;
        do {
          before = tip(*strand);
          for (int k = 0; k < 20; ++k, ++steps) {
            advance(*strand, h, 1);
            const BodyState state(*strand);
            strand->write(state.q, VectorXd::Zero(state.q.size()));
          }
        } while ((tip(*strand) - before).norm() > row.settled * L && steps < 40000);
        errors[fine] = (Eigen::Vector2d(tip(*strand).x(), -tip(*strand).z()) - exact).norm();
      }
      SCOPED_TRACE(std::string(row.model) + ", Gamma " + std::to_string(gamma) + ": " +
                   std::to_string(errors[0] / L) + ", " + std::to_string(errors[1] / L));
      EXPECT_LE(errors[1], 0.01 * L);
      EXPECT_GE(std::log2(errors[0] / errors[1]), row.least_order);
      EXPECT_LE(std::log2(errors[0] / errors[1]), row.most_order);
    }
}

}  // namespace
}  // namespace hair
