// STAFF ONLY. The given simulation with the reference's exercises: it follows its description, and reports
// when a strand breaks.

#include "hair/simulation/simulation.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

#include "hair/simulation/test_hairs.h"
#include "hair/strand/measures.h"
#include "solver/test_allocations.h"
#include "solver/test_numbers.h"
#include "solver/test_refusal.h"

namespace reference_tests {
namespace {

// Free particles fall exactly as each method says, because gravity is constant.
TEST(Simulation, FreeParticlesFallAsTheirMethodSays) {
  const double h = 0.01, n = 20;
  const auto fallen = [&](Method method) {
    StrandStart start = straight_hair(1, 0.1, Vector3d::UnitX());
    start.strand.stretch_rigidity = start.strand.bend_rigidity = 0;
    Description description = alone(std::move(start), method, h);
    description.gravity = kG * kDown;
    Simulation simulation(std::move(description));
    EXPECT_FALSE(simulation.advance(static_cast<long>(n)));
    EXPECT_DOUBLE_EQ(simulation.time(), n * h);
    return -particle(simulation, 1)[2] / (kG * h * h);
  };
  const double bound = 1e-12;  // 20 steps of a few roundings, squared in the sum
  EXPECT_NEAR(fallen(Method::forward_euler), n * (n - 1) / 2, bound * n * n);
  EXPECT_NEAR(fallen(Method::symplectic_euler), n * (n + 1) / 2, bound * n * n);
  EXPECT_NEAR(fallen(Method::midpoint), n * n / 2, bound * n * n);
  EXPECT_NEAR(fallen(Method::runge_kutta_4), n * n / 2, bound * n * n);
  EXPECT_NEAR(fallen(Method::implicit_euler), n * (n + 1) / 2, bound * n * n);
}

TEST(Simulation, TheRootGoesWhereItIsToldTo) {
  for (Method method : kMethods) {
    StrandStart start = straight_hair(5, 0.05);
    start.state.v.head<3>() = Vector3d(0.1, 0, 0.2);
    Description description = alone(std::move(start), method, 1e-6);
    description.gravity = kG * kDown;
    Simulation simulation(std::move(description));
    simulation.advance(100);
    simulation.set_root_velocity(0, Vector3d(0, -0.3, 0));
    EXPECT_FALSE(simulation.advance(50));
    EXPECT_LE((particle(simulation, 0) - Vector3d(1e-5, -1.5e-5, 2e-5)).norm(), 150 * kUnit * 1e-5)
        << name_of(method);
  }
}

TEST(Simulation, StrandsDoNotFeelEachOther) {
  for (Method method : kMethods) {
    StrandStart other = straight_hair(4, 0.06, Vector3d::UnitX()),
                same = straight_hair(6, 0.06, Vector3d::UnitY());
    Description together, single;
    together.method = single.method = method;
    together.step = single.step = 1e-6;
    together.strands = {other, same};
    single.strands = {same};
    Simulation both(together), one(single);
    EXPECT_FALSE(both.advance(30));
    EXPECT_FALSE(one.advance(30));
    EXPECT_EQ(both.state(1).x, one.state(0).x) << name_of(method);
    EXPECT_EQ(both.state(1).v, one.state(0).v) << name_of(method);
  }
}

// The effect of wind does not depend on the number of segments: the tip of a light, limp hair leans as far.
TEST(Simulation, DragIsForEachMetreOfHair) {
  const auto force_of = [](int segments) {
    Description description = alone(straight_hair(segments, 0.1), Method::implicit_euler, 0.001);
    description.drag = 2e-4;
    description.wind = Vector3d(3, 0, 0);
    const Simulation simulation(std::move(description));
    Eigen::VectorXd f = Eigen::VectorXd::Zero(simulation.state(0).x.size());
    simulation.force(0).add_force(simulation.state(0).x, simulation.state(0).v, f);
    double along = 0;
    for (Eigen::Index k = 0; k < f.size(); k += 3) along += f[k];
    return along;
  };
  EXPECT_NEAR(force_of(1), 2e-4 * 0.1 * 3, 1e-18);
  EXPECT_NEAR(force_of(64), 2e-4 * 0.1 * 3, 1e-18);
}

// --- Breaking ---

TEST(Simulation, ForwardEulerBreaksOnHairAndSaysWhere) {
  StrandStart fine = straight_hair(1, 1, kDown), hair = straight_hair(10, 0.1, Vector3d::UnitX());
  fine.strand.stretch_rigidity = 0;
  Description description;
  description.method = Method::forward_euler;
  description.step = 1e-4;
  description.strands = {fine, hair};
  Simulation simulation(description);
  const auto blow_up = simulation.advance(10'000);
  ASSERT_TRUE(blow_up);
  EXPECT_EQ(blow_up->strand, 1);
  EXPECT_EQ(blow_up->step, simulation.steps());
  EXPECT_LT(blow_up->step, 100);  // h w = 1e-4 * 2 * 15e4 grows by 1e3 at least in a step, from 1e-8 m on
  EXPECT_EQ(blow_up->stage, hair::Stage::integration);
  EXPECT_STREQ(stage_name(blow_up->stage), "integration");

  // The simulation stays as it is.
  const particles::State broken = simulation.state(0);
  const auto again = simulation.step();
  ASSERT_TRUE(again);
  EXPECT_EQ(again->step, blow_up->step);
  EXPECT_EQ(simulation.steps(), blow_up->step);
  EXPECT_EQ(simulation.state(0).x, broken.x);
}

TEST(Simulation, ImplicitMethodsNameTheStageThatBroke) {
  for (Method method : {Method::implicit_euler, Method::predictor_corrector}) {
    Simulation simulation(alone(straight_hair(5, 0.05), method, 0.01));
    EXPECT_FALSE(simulation.advance(3));
    simulation.set_root_velocity(0, Vector3d(1e300, 0, 0));
    const auto blow_up = simulation.advance(100);
    ASSERT_TRUE(blow_up) << name_of(method);
    EXPECT_EQ(blow_up->strand, 0);
    EXPECT_EQ(blow_up->step, 4);
    EXPECT_NE(blow_up->stage, hair::Stage::integration);
    EXPECT_NE(blow_up->stage, hair::Stage::collision);
  }
}

// --- Bad input ---

std::string refusal(const std::function<void(Description&)>& spoil) {
  Description description = alone(straight_hair(3, 0.3), Method::predictor_corrector, 0.01);
  spoil(description);
  return tests::refusal<std::invalid_argument>([&] { Simulation simulation(std::move(description)); });
}

TEST(Simulation, RefusesWhatIsOutOfBoundsAndSaysWhat) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal([](Description&) {}), "");
  EXPECT_EQ(refusal([](Description& d) { d.strands.clear(); }), "");
  EXPECT_EQ(refusal([](Description& d) { d.step = 0; }), "the step is 0; it must be finite and > 0");
  EXPECT_EQ(refusal([&](Description& d) { d.step = nan; }), "the step is nan; it must be finite and > 0");
  EXPECT_EQ(refusal([](Description& d) { d.tolerance = -1; }),
            "the tolerance is -1; it must be finite and at least 0");
  EXPECT_EQ(refusal([](Description& d) { d.drag = -2; }), "the drag is -2; it must be finite and at least 0");
  EXPECT_EQ(refusal([&](Description& d) { d.gravity[1] = nan; }), "gravity is nan; it must be finite");
  EXPECT_EQ(refusal([&](Description& d) { d.wind[1] = nan; }), "the wind is nan; it must be finite");
  EXPECT_NE(refusal([](Description& d) { d.obstacles = {{hair::Sphere{Vector3d::Zero(), -1}}}; }), "");
  EXPECT_EQ(refusal([](Description& d) { d.strands[0].strand.mass[1] = 0; }),
            "strand 0: a mass is 0; it must be finite and > 0");
  EXPECT_EQ(refusal([](Description& d) { d.strands[0].strand.rest_length[1] = -0.1; }),
            "strand 0: a rest length is -0.10000000000000001; it must be finite and > 0");
  EXPECT_EQ(refusal([](Description& d) { d.strands[0].strand.rest_length.conservativeResize(2); }),
            "strand 0: the number of segments is 2; it must be 3");
  EXPECT_EQ(refusal([](Description& d) { d.strands[0].state.x.conservativeResize(9); }),
            "strand 0: the numbers in x is 9; it must be 12");
  EXPECT_EQ(refusal([](Description& d) { d.strands[0].state.v.conservativeResize(9); }),
            "strand 0: the numbers in v is 9; it must be 12");
  EXPECT_EQ(refusal([&](Description& d) { d.strands[0].state.v[4] = nan; }),
            "strand 0: a velocity is nan; it must be finite");
  EXPECT_EQ(refusal([](Description& d) { d.strands[0].strand.stretch_rigidity = -1; }),
            "strand 0: EA is -1; it must be finite and at least 0");
  EXPECT_EQ(refusal([](Description& d) {
              d.strands[0].strand.clamped = true;
              d.strands[0].strand.root_tangent *= 2;
            }),
            "strand 0: the root's tangent: its length is 2; it must be 1");
}

TEST(Simulation, RefusesARestCurvatureThatDoesNotFit) {
  const StrandStart curl = hair::start_at_rest({}, hair::curly_shape(12, 0.1, 0.01, 0.03, {}));
  EXPECT_NE(refusal([&](Description& d) {
              d.strands = {curl};
              d.strands[0].rest_curvature.conservativeResize(23);
            }),
            "");
  EXPECT_NE(refusal([&](Description& d) {
              d.strands = {curl};
              d.strands[0].strand.clamped = false;
            }),
            "");
  for (const double rigidity : {0.0, curl.strand.bend_rigidity})
    EXPECT_EQ(refusal([&](Description& d) {
                d.strands = {curl};
                d.strands[0].strand.bend_rigidity = rigidity;
                d.strands[0].rest_curvature[5] = std::numeric_limits<double>::quiet_NaN();
              }),
              "strand 0: a component of the rest curvature is nan; it must be finite");
}

TEST(Simulation, ARestCurvatureOfWhatDoesNotBendHasNoEffect) {
  StrandStart curl = hair::start_at_rest({}, hair::curly_shape(12, 0.1, 0.01, 0.03, {}));
  curl.strand.stretch_rigidity = curl.strand.bend_rigidity = 0;
  curl.rest_curvature.array() += 1;
  Simulation simulation(alone(curl, Method::implicit_euler, 0.01));
  EXPECT_FALSE(simulation.advance(10));
  EXPECT_EQ(simulation.state(0).x, curl.state.x);
}

// --- Memory ---

// The reference allocates three vectors in ConjGrad, and a vector, a matrix and its memory: 6 for H4, 12 for
// the two solves of H6.
TEST(Simulation, AStepAllocatesNothingBeyondConjGradAndTheMatrix) {
  for (Method method : kMethods) {
    Description description = alone(straight_hair(8, 0.08, Vector3d::UnitX()), method, 1e-6);
    description.gravity = kG * kDown;
    description.drag = 1e-5;
    description.strands.push_back(straight_hair(4, 0.08, Vector3d::UnitY()));
    description.strands[1].strand.skip_rigidity = 1;
    description.strands.push_back(hair::start_at_rest({}, hair::curly_shape(12, 0.1, 0.01, 0.03, {})));
    description.obstacles = {{hair::Plane{Vector3d(0, 0, 0.001), Vector3d::UnitZ()}, 0.5}};
    Simulation simulation(std::move(description));
    simulation.step();
    const long before = allocations();
    for (int step = 0; step < 10; ++step) simulation.step();
    const long expected = method == Method::implicit_euler        ? 6
                          : method == Method::predictor_corrector ? 12
                                                                  : 0;
    EXPECT_EQ(allocations() - before, 10 * 3 * expected) << name_of(method);
    EXPECT_GT(simulation.work().contacts, 0);
  }
}

}  // namespace
}  // namespace reference_tests
