// STAFF ONLY. The effect of a description's options in the given simulation: those of implicit methods, and
// the number of threads, which changes nothing.

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "hair/mass_spring/rest_curvature.h"
#include "hair/predictor_corrector.h"
#include "hair/simulation/simulation.h"
#include "hair/simulation/strand_threads.h"
#include "hair/simulation/test_hairs.h"

namespace reference_tests {
namespace {

using hair::StrandThreads;

Eigen::VectorXd product(const particles::Force& force, const particles::State& at,
                        const Eigen::VectorXd& dx) {
  Eigen::VectorXd df = Eigen::VectorXd::Zero(dx.size());
  force.add_dfdx(at.x, at.v, dx, df);
  return df;
}

// If one end of a spring of length l moves across it by 1, the force is -k (1 - l0/l) with the full term.
TEST(SimulationDescription, SpringsTurnAsTheGeometricTermSays) {
  const auto stiffness_across = [](int segments, double stretch, hair::GeometricTerm term) {
    StrandStart start = straight_hair(segments, 0.5);
    start.strand.stretch_rigidity = segments == 1 ? 3 : 0;
    start.strand.skip_rigidity = segments == 1 ? 0 : 3;
    start.strand.bend_rigidity = 0;
    start.state.x *= stretch;
    Description description = alone(start, Method::implicit_euler, 0.01);
    description.geometric_term = term;
    const Simulation simulation(std::move(description));
    Eigen::VectorXd dx = Eigen::VectorXd::Zero(start.state.x.size());
    dx[3 * segments] = 1;
    return -product(simulation.force(0), start.state, dx)[3 * segments];
  };
  using hair::GeometricTerm;
  for (const int segments : {1, 2})  // H1's spring, and H3's
    for (const double stretch : {0.5, 1.5}) {
      const double k = 3 / 0.5, across = k * (1 - 1 / stretch);
      const double bound = 8 * 0x1p-53 * k;
      EXPECT_NEAR(stiffness_across(segments, stretch, GeometricTerm::full), across, bound);
      EXPECT_NEAR(stiffness_across(segments, stretch, GeometricTerm::filtered), std::max(across, 0.0), bound);
      EXPECT_EQ(stiffness_across(segments, stretch, GeometricTerm::dropped), 0);
    }
}

// The two products differ for bent hair, away from its rest shape.
TEST(SimulationDescription, BendsHaveTheProductThatItAsksFor) {
  StrandStart curl = hair::start_at_rest({}, hair::curly_shape(12, 0.1, 0.01, 0.03, {}));
  curl.strand.stretch_rigidity = 0;
  curl.state.x.tail<3>() += Vector3d(0.002, -0.001, 0);
  StrandStart bent = curl;
  bent.rest_curvature.resize(0);
  const Eigen::VectorXd dx = Eigen::VectorXd::LinSpaced(curl.state.x.size(), -1, 2).array().sin();

  const auto product_in_simulation = [&](const StrandStart& start, particles::Products bend_product) {
    Description description = alone(start, Method::implicit_euler, 0.01);
    description.bend_product = bend_product;
    return product(Simulation(std::move(description)).force(0), start.state, dx);
  };
  for (const particles::Products asked : {particles::Products::exact, particles::Products::definite}) {
    const hair::BendForce springs(bent.strand, asked);
    EXPECT_EQ(product_in_simulation(bent, asked), product(springs, bent.state, dx));
    const hair::RestCurvature rest(curl.strand, curl.rest_curvature, curl.root_normal, asked);
    EXPECT_EQ(product_in_simulation(curl, asked), product(rest, curl.state, dx));
  }
  for (const StrandStart& start : {bent, curl})
    EXPECT_NE(product_in_simulation(start, particles::Products::exact),
              product_in_simulation(start, particles::Products::definite));
}

// A step of the simulation is the exercise's with the description's numbers, bit by bit.
TEST(SimulationDescription, StepsAreSolvedToItsTolerance) {
  const double h = 1.0 / 240;
  const StrandStart start = straight_hair(30, 0.3, Vector3d(0.6, 0, -0.8));
  for (const Method method : {Method::implicit_euler, Method::predictor_corrector}) {
    std::vector<Eigen::VectorXd> velocities;
    for (const double tolerance : {1e-2, 1e-5, 1e-10}) {
      Description description = alone(start, method, h);
      description.gravity = kG * kDown;
      description.tolerance = tolerance;
      description.preconditioner = false;  // with it this hair is solved at once
      Simulation simulation(std::move(description));
      particles::State expected = simulation.state(0);
      ASSERT_FALSE(simulation.step());

      Eigen::MatrixXd scratch(expected.x.size(), hair::kPredictorCorrectorScratch);
      if (method == Method::implicit_euler)
        implicit_euler(simulation.force(0), simulation.particles(0), h, tolerance, expected, scratch);
      else
        predictor_corrector(simulation.force(0), simulation.particles(0), simulation.strand(0), h, tolerance,
                            expected, scratch);
      EXPECT_EQ(simulation.state(0).x, expected.x) << name_of(method) << ", " << tolerance;
      EXPECT_EQ(simulation.state(0).v, expected.v) << name_of(method) << ", " << tolerance;
      for (const Eigen::VectorXd& other : velocities) EXPECT_NE(expected.v, other) << name_of(method);
      velocities.push_back(expected.v);
    }
  }
}

// --- Threads: no result of a simulation depends on their number. ---

TEST(StrandThreadsTest, DoEachTaskOnceAndEachThreadOneAtATime) {
  for (int count : {1, 2, 5}) {
    StrandThreads threads(count);
    EXPECT_EQ(threads.count(), count);
    for (int tasks : {0, 1, 3, 1000}) {
      std::vector<std::atomic<int>> done(tasks), busy(count);
      threads.run(tasks, [&](int thread, int i) {
        EXPECT_EQ(busy[thread]++, 0);
        ++done[i];
        --busy[thread];
      });
      for (const std::atomic<int>& times : done) EXPECT_EQ(times, 1);
    }
  }
}

TEST(StrandThreadsTest, PassOnTheFirstExceptionAndGoOnAfterwards) {
  StrandThreads threads(3);
  for (int round = 0; round < 20; ++round) {
    try {
      threads.run(50, [](int, int i) {
        if (i == 7) throw std::runtime_error("seven");
      });
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "seven");
    }
    std::atomic<int> done = 0;
    threads.run(50, [&](int, int) { ++done; });
    EXPECT_EQ(done, 50);
  }
}

TEST(StrandThreadsTest, DoNotChangeTheResult) {
  for (const Method method :
       {Method::symplectic_euler, Method::implicit_euler, Method::predictor_corrector}) {
    Description description;
    for (int i = 0; i < 9; ++i)
      description.strands.push_back(straight_hair(3 + 4 * i, 0.03 + 0.04 * i, Vector3d(0.6, 0, -0.8)));
    description.method = method;
    description.step = method == Method::symplectic_euler ? 1e-6 : 1.0 / 240;
    Simulation one(description);
    one.advance(30);
    for (int jobs : {2, 4}) {
      description.jobs = jobs;
      Simulation several(description);
      several.advance(30);
      for (int i = 0; i < one.strands(); ++i) {
        EXPECT_EQ(several.state(i).x, one.state(i).x) << jobs << " threads, strand " << i;
        EXPECT_EQ(several.state(i).v, one.state(i).v) << jobs << " threads, strand " << i;
      }
      EXPECT_EQ(several.work().strand_steps, one.work().strand_steps);
      EXPECT_EQ(several.work().solver_steps, one.work().solver_steps);
      EXPECT_EQ(several.work().correction_steps, one.work().correction_steps);
    }
  }
}

// Explicit steps far beyond their limit: strands break, the stiffest one first.
TEST(StrandThreadsTest, TellOfTheSameBlowUp) {
  Description description;
  for (int i = 0; i < 6; ++i)
    description.strands.push_back(straight_hair(10, 0.3 - 0.04 * i, Vector3d::UnitX()));
  description.method = Method::symplectic_euler;
  description.step = 1.0 / 240;
  Simulation one(description);
  const auto expected = one.advance(200);
  ASSERT_TRUE(expected);
  description.jobs = 3;
  Simulation several(description);
  const auto blow_up = several.advance(200);
  ASSERT_TRUE(blow_up);
  EXPECT_EQ(blow_up->strand, expected->strand);
  EXPECT_EQ(blow_up->step, expected->step);
}

}  // namespace
}  // namespace reference_tests
