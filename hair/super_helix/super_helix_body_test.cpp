// STAFF ONLY. Super-helices, in addition to the common properties of bodies
// (hair/simulation/bodies_test.cpp).
#include "hair/super_helix/super_helix_body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "hair/simulation/models.h"
#include "hair/strand/test_bodies.h"
#include "hair/strand/turns.h"

namespace hair {
namespace {

using Eigen::VectorXd;

std::unique_ptr<SuperHelixBody> body(const StrandSpec& spec,
                                     HelixSurroundings surroundings = {Vector3d(0, 0, -9.81)}) {
  surroundings.relaxation_time = spec.fibre.relaxation_time;
  return std::make_unique<SuperHelixBody>(helix_start(spec), surroundings, spec.root_velocity);
}

// For a wave each element has the mean curvature: it turns with the wave, and ends near it, to the second
// order.
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

// Overdamped bends return like exp(-t / tau).
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

// Kirchhoff's rod by two models that share only its constants. A sagging level curl bends back and forth with
// each turn, so an element should be a small part of a turn.
TEST(SuperHelixBody, FallsAsRigidLinksDo) {
  StrandSpec spec = level(curl(24));
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

// A level hair whose root is shaken from the first step on, or held.
struct Whirl {
  double h, speed;  // s, m/s
  double bend_factor;
  int elements;
  double length;  // m
};

double gain_of(const Whirl& whirl) {
  StrandSpec spec = level(straight_hair(whirl.elements, whirl.length), -Vector3d::UnitY());
  spec.fibre.bend_factor = spec.fibre.twist_factor = whirl.bend_factor;
  SuperHelixBody strand(helix_start(spec), {Vector3d(0, 0, -9.81)}, Vector3d::Zero(), true);
  Eigen::MatrixXd scratch(strand.scratch_rows(), strand.scratch_columns());
  Work work;
  Vector3d position = Vector3d::Zero();
  for (int k = 0; k * whirl.h < 1.5; ++k) {
    const double phase = 50 * k * whirl.h;
    const Vector3d velocity = whirl.speed * Vector3d(std::sin(phase), std::sin(2 * phase), std::sin(phase));
    position += whirl.h * velocity;
    strand.set_root({position, spec.root.axis, spec.root.side, velocity, Vector3d::Zero()});
    EXPECT_FALSE(strand.step({whirl.h, 1e-10, {}, {}}, scratch, work));
  }
  return strand.sizes()[Concern::energy];
}

// Steps that are too long for a whip lose energy. Its books show no gain, and show a true one: weight is
// explicit, and too heavy for the last two.
TEST(SuperHelixBody, BooksOfAWhipBalance) {
  for (const Whirl& whirl :
       {Whirl{1.0 / 60, 2, 1, 10, 0.2}, Whirl{1.0 / 240, 2, 1, 10, 0.2}, Whirl{1.0 / 240, 2, 10, 10, 0.1},
        Whirl{1.0 / 960, 2, 1, 10, 0.2}, Whirl{1.0 / 240, 1, 1, 20, 0.3}, Whirl{1.0 / 240, 0, 1, 10, 0.6}})
    EXPECT_LE(gain_of(whirl), 1e-3) << whirl.length << " m, " << whirl.speed << " m/s, h = " << whirl.h;
  for (const Whirl& whirl : {Whirl{1.0 / 30, 0, 1, 40, 1}, Whirl{1.0 / 60, 0, 1e-3, 10, 0.3}})
    EXPECT_GT(gain_of(whirl), 0.5) << whirl.length << " m, h = " << whirl.h;
}

TEST(SuperHelixBody, ADrawnStrandRestsNearItsPoints) {
  StrandSpec spec = curl(48);
  const RestShape shape = rest_shape(spec);
  spec.form = Drawn{shape.x};
  spec.length = 0;
  for (int i = 0; i < spec.elements; ++i)
    spec.length += (shape.x.segment<3>(3 * i + 3) - shape.x.segment<3>(3 * i)).norm();
  const auto strand = body(spec);
  // The error is of second order in a piece's angle, 0.2 rad: 1 % of the length.
  EXPECT_LE((tip(*strand) - Vector3d(shape.x.tail<3>())).norm(), 0.02 * spec.length);
}

}  // namespace
}  // namespace hair
