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
