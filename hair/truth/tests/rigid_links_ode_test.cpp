// STAFF ONLY. Accurate motions of rigid links: closed forms, an independent integration, energies.
#include "hair/truth/rigid_links_ode.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hair/scene/playback.h"
#include "hair/simulation/models.h"
#include "hair/truth/content.h"
#include "problems.h"

namespace reference_tests {
namespace {

using Eigen::VectorXd;
using hair::AccurateMotion, hair::Method, hair::Problem, hair::StrandSpec, hair::Vector3d;

// Level, made of rods of 2 cm, ten thousand times as easy to bend and to twist as hair.
StrandSpec soft(int elements) {
  StrandSpec spec;
  spec.elements = elements;
  spec.length = 0.02 * elements;
  spec.root.axis = Vector3d::UnitX();
  spec.root.side = Vector3d::UnitZ();
  spec.fibre.bend_factor = spec.fibre.twist_factor = 1e-4;
  return spec;
}

// A curl, so that its rods bend and twist.
StrandSpec soft_curl(int elements) {
  StrandSpec spec = soft(elements);
  spec.form = hair::Curly{0.01, 0.05};
  return spec;
}

hair::Scene scene_of(const StrandSpec& spec) {
  hair::Scene scene;
  scene.name = "links";
  scene.hair.modelled = {{hair::find_model("rigid_links"), spec}};
  return scene;
}

Problem problem_of(const hair::Scene& scene, double duration) {
  return hair::make_problem(scene, {.strand = 0, .duration = duration, .segments = {}});
}

// The largest distance of a point from the accurate motion, at any moment, for a method with so many steps a
// moment.
double error_of(const Problem& problem, const AccurateMotion& motion, Method method, int steps) {
  hair::Scene scene = problem.scene;
  scene.hair.method = method;
  scene.steps_per_frame = steps;
  scene.hair.step = problem.duration / scene.frames / steps;
  hair::Playback playback(scene);
  double largest = 0;
  for (const particles::State& state : motion.states) {
    largest = std::max(largest, hair::largest_distance(playback.centre_lines(playback.state()).x,
                                                       playback.centre_lines(state).x));
    if (playback.frame() < scene.frames) {
      EXPECT_FALSE(playback.advance());
    }
  }
  return largest;
}

TEST(LinksOde, StartsWhereItsBodyStarts) {
  StrandSpec spec = soft_curl(7);
  for (const bool held : {false, true}) {
    if (held) spec.start = {true, Vector3d(0.6, 0, 0.8), 1, false, Vector3d(3, 1, -2)};
    const Problem problem = problem_of(scene_of(spec), 0.1);
    hair::LinksOde ode(problem);
    const particles::State state = ode.state(0, ode.start());
    const auto body = hair::modelled_body(problem);
    VectorXd q(body->size()), rate(body->size());
    body->read(q, rate);
    EXPECT_LE((state.x - q).norm(), 1e-14);
    EXPECT_LE((state.v - rate).norm(), 1e-13);
  }
}

// In air with drag and wind. Runge and Kutta's steps are independent of CVODE's; with order 4, the error is c
// h^4, so two step sizes give c: the finer one's error is a fifteenth of their difference.
TEST(LinksOde, MovesAsRungeAndKuttaSay) {
  hair::Scene scene = scene_of(soft_curl(6));
  scene.hair.drag = 2e-4;
  scene.hair.wind = Vector3d(0, 0.5, 0);
  const Problem problem = problem_of(scene, 0.1);
  const AccurateMotion motion = motion_of(problem);
  EXPECT_LE(motion.agreement, hair::kLeastError);
  const double coarse = error_of(problem, motion, Method::runge_kutta_4, 8),
               fine = error_of(problem, motion, Method::runge_kutta_4, 16);
  EXPECT_NEAR(std::log2(coarse / fine), 4, 0.25) << coarse << " m, " << fine << " m";
  EXPECT_LE(fine, 1e-8);
}

TEST(LinksOde, KeepsTheEnergyWithoutDrag) {
  const Problem problem = problem_of(scene_of(soft_curl(6)), 0.1);
  const AccurateMotion motion = motion_of(problem);
  const hair::Playback playback(problem.scene);
  const double start = playback.measure(motion.states.front()).energy();
  const double kinetic = playback.measure(motion.states.back()).kinetic;
  ASSERT_GT(kinetic, 0);
  for (const particles::State& state : motion.states)
    EXPECT_LE(std::abs(playback.measure(state).energy() - start), 1e-8 * kinetic) << "of " << kinetic << " J";
}

// A rod whose hinge starts with v across it: in the hinge's frame, its middle gets the impulse -m v, and so
// it turns with m v (L/2) / (m L^2/3 + m r^2/4) for ever, because the hinge moves on steadily.
TEST(LinksOde, ABlowAtTheRootTurnsARodAsInTheClosedForm) {
  StrandSpec spec = soft(1);
  spec.clamped = false;
  spec.root_velocity = Vector3d(0, 0.3, 0);
  hair::Scene scene = scene_of(spec);
  scene.hair.gravity.setZero();
  const Problem problem = problem_of(scene, 0.1);
  const AccurateMotion motion = motion_of(problem);
  const hair::Playback playback(problem.scene);
  const double length = spec.length, radius = spec.fibre.material.radius;
  const double omega = -0.3 * length / 2 / (length * length / 3 + radius * radius / 4);
  for (int k = 0; k <= hair::kMoments; ++k) {
    const double t = problem.duration * k / hair::kMoments;
    const VectorXd x = playback.centre_lines(motion.states[k]).x;
    const Vector3d hinge(0, 0.3 * t, 0), rod(std::cos(omega * t), std::sin(omega * t), 0);
    EXPECT_LE((x.head<3>() - hinge).norm(), 1e-14) << "at " << t << " s";
    EXPECT_LE((x.tail<3>() - hinge - length * rod).norm(), 1e-11) << "at " << t << " s";
  }
}

// The root's own motion has a first-order error in steps, which move to the root's position at their end with
// a constant velocity.
TEST(LinksOde, ARootThatIsCarriedAndTurnedLeadsItAsItLeadsSteps) {
  hair::Scene scene = scene_of(soft_curl(5));
  scene.riders = carried_strand().scene.riders;
  const Problem problem = problem_of(scene, 0.1);
  const AccurateMotion motion = motion_of(problem);
  const hair::Motion& carried = scene.riders[0].motion;
  for (int k = 0; k <= hair::kMoments; ++k)
    EXPECT_LE(
        (motion.states[k].x.head<3>() - hair::way_at(carried, 0.1 * k / hair::kMoments)(Vector3d::Zero()))
            .norm(),
        1e-15);
  double before = error_of(problem, motion, Method::symplectic_euler, 200);
  EXPECT_LE(before, 1e-3);
  for (const int steps : {400, 800, 1600}) {
    const double error = error_of(problem, motion, Method::symplectic_euler, steps);
    EXPECT_NEAR(std::log2(before / error), 1, 0.15) << before << " m, " << error << " m";
    before = error;
  }
}

TEST(LinksOde, ContentIsAllThatMovesTheStrand) {
  const hair::Scene scene = scene_of(soft_curl(5));
  const std::string content = hair::content_of(problem_of(scene, 0.1));
  const auto differs = [&](const auto& change) {
    hair::Scene other = scene;
    change(other.hair.modelled[0].spec);
    return hair::content_of(problem_of(other, 0.1)) != content;
  };
  EXPECT_TRUE(differs([](StrandSpec& spec) { spec.fibre.twist_factor *= 2; }));
  EXPECT_TRUE(differs([](StrandSpec& spec) { spec.fibre.material.density *= 2; }));
  EXPECT_TRUE(differs([](StrandSpec& spec) { spec.fibre.joint_limit = 0.1; }));
  EXPECT_TRUE(differs([](StrandSpec& spec) { spec.form = hair::Curly{0.01, 0.06}; }));
  EXPECT_TRUE(differs([](StrandSpec& spec) { ++spec.elements; }));
  EXPECT_TRUE(differs([](StrandSpec& spec) { spec.root_velocity.x() = 1; }));
  EXPECT_TRUE(differs([](StrandSpec& spec) { spec.start.spin.x() = 1; }));
  hair::Scene named = scene;
  named.name = "another";
  named.hair.method = Method::runge_kutta_4;
  EXPECT_EQ(hair::content_of(problem_of(named, 0.1)), content);
}

}  // namespace
}  // namespace reference_tests
