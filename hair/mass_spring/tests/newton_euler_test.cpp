// STAFF ONLY. Implicit Euler to convergence: its equation holds, and where forces are linear it is H4.
#include "hair/mass_spring/newton_euler.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hair/simulation/simulation.h"
#include "hair/strand/make_strand.h"
#include "particles/drag.h"
#include "particles/force_sum.h"
#include "particles/gravity.h"
#include "particles/implicit_euler.h"
#include "particles/springs.h"

namespace reference_tests {
namespace {

using hair::Method;
using particles::State;

// Another force, which counts how often it is asked.
class CountedForce : public particles::Force {
 public:
  explicit CountedForce(const particles::Force& force) : force_(force) {}

  double energy(particles::Input x) const override { return force_.energy(x); }
  void add_force(particles::Input x, particles::Input v, particles::Output f) const override {
    ++forces;
    force_.add_force(x, v, f);
  }
  void add_dfdx(particles::Input x, particles::Input v, particles::Input dx,
                particles::Output df) const override {
    force_.add_dfdx(x, v, dx, df);
  }
  void add_dfdv(particles::Input x, particles::Input v, particles::Input dv,
                particles::Output df) const override {
    force_.add_dfdv(x, v, dv, df);
  }
  bool add_band(particles::Input x, particles::Input v, double by_dfdx, double by_dfdv,
                solver::BlockBand& band, particles::Scratch work) const override {
    return force_.add_band(x, v, by_dfdx, by_dfdv, band, work);
  }

  mutable int forces = 0;

 private:
  const particles::Force& force_;
};

hair::NewtonReport step(const particles::Force& force, const particles::Force& definite,
                        const particles::Particles& particles, double h, State& state) {
  Eigen::MatrixXd scratch(state.x.size(), hair::kNewtonScratch);
  return hair::newton_euler(force, definite, particles, h, state, scratch);
}

// A spring of no length at rest is linear.
TEST(NewtonEuler, IsH4OfLinearForces) {
  const particles::Particles particles{Eigen::Vector3d(1, 2, 0.5), {1, 0, 0}};
  particles::ForceSum force;
  force.emplace<particles::Gravity>(particles.mass, hair::Vector3d(0, 0, -9.81));
  force.emplace<particles::Drag>(Eigen::Vector3d(0.1, 0.2, 0.3), hair::Vector3d(1, 0, 0));
  force.emplace<particles::DampedSprings>(std::vector<particles::Spring>{{0, 1, 50, 0}, {1, 2, 80, 0}});
  State newton{Eigen::VectorXd::LinSpaced(9, -1, 1), Eigen::VectorXd::LinSpaced(9, 2, -1)}, linear = newton;
  constexpr double kStep = 0.05;
  EXPECT_TRUE(step(force, force, particles, kStep, newton).converged);
  Eigen::MatrixXd scratch(9, particles::kImplicitScratch);
  particles::implicit_euler(force, particles, kStep, 1e-14, linear, scratch);
  EXPECT_LE((newton.v - linear.v).norm(), 1e-12 * linear.v.norm());
  EXPECT_LE((newton.x - linear.x).norm(), 1e-12 * linear.x.norm());
}

TEST(NewtonEuler, OfADampedSpringIsTheClosedForm) {
  constexpr double kMass = 0.2, kStiffness = 30, kDamping = 0.4, kStep = 0.1, kAway = 0.3, kSpeed = -2;
  const particles::Particles particles{Eigen::Vector2d(1, kMass), {1, 0}};
  particles::DampedSprings spring({{0, 1, kStiffness, 1, kDamping}});
  State state{Eigen::VectorXd::Zero(6), Eigen::VectorXd::Zero(6)};
  state.x[3] = 1 + kAway;
  state.v[3] = kSpeed;
  EXPECT_TRUE(step(spring, spring, particles, kStep, state).converged);
  const double u = (kSpeed - kStep * kStiffness / kMass * kAway) /
                   (1 + kStep * kDamping / kMass + kStep * kStep * kStiffness / kMass);
  EXPECT_NEAR(state.v[3], u, 1e-12);
  EXPECT_NEAR(state.x[3], 1 + kAway + kStep * u, 1e-12);
}

hair::Description folded_strand(Method method, double step) {
  constexpr int kSegments = 10;
  hair::StrandStart start;
  start.strand = hair::uniform_strand({}, kSegments, 0.1);
  start.strand.stretch_rigidity *= 1e-3;
  start.state.x = start.state.v = Eigen::VectorXd::Zero(3 * (kSegments + 1));
  for (int i = 0; i <= kSegments; ++i)
    start.state.x.segment<3>(3 * i) << 0.009 * i, 0.003 * (i % 2), 0.002 * (i % 3);  // compressed, a zigzag
  hair::Description description;
  description.strands = {start};
  description.method = method;
  description.step = step;
  return description;
}

TEST(NewtonEuler, LeavesNothingOfItsEquation) {
  for (const double h : {1e-4, 1e-3, 1e-2}) {
    hair::Simulation simulation(folded_strand(Method::newton_euler, h));
    const State before = simulation.state(0);
    ASSERT_FALSE(simulation.step());
    ASSERT_EQ(simulation.work().unconverged, 0) << h;
    const State& after = simulation.state(0);
    Eigen::VectorXd force = Eigen::VectorXd::Zero(before.x.size());
    simulation.force(0).add_force(after.x, after.v, force);
    const Eigen::VectorXd& mass = simulation.particles(0).mass;
    for (int i = 1; i < mass.size(); ++i) {
      const hair::Vector3d gained = mass[i] * (after.v - before.v).segment<3>(3 * i);
      EXPECT_LE((gained - h * force.segment<3>(3 * i)).norm(), 1e-8 * gained.norm())
          << "particle " << i << ", h = " << h;
    }
    EXPECT_LE((after.x - before.x - h * after.v).norm(), 1e-15);
  }
}

TEST(NewtonEuler, TakesTheDefiniteMatrixWhereTheExactOneIsNotAndCountsAllEvaluations) {
  int halvings = 0;
  for (const double h : {0.02, 0.1}) {
    const hair::Description description = folded_strand(Method::newton_euler, h);
    const hair::Strand& strand = description.strands[0].strand;
    particles::ForceSum exact, definite;
    exact.emplace<hair::StretchForce>(strand, hair::GeometricTerm::full);
    definite.emplace<hair::StretchForce>(strand, hair::GeometricTerm::filtered);
    const CountedForce counted(exact);
    const particles::Particles particles{strand.mass, {1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}};
    State state = description.strands[0].state;
    const hair::NewtonReport report = step(counted, definite, particles, h, state);
    EXPECT_TRUE(report.converged) << "h = " << h;
    EXPECT_GT(report.definite_steps, 0) << "h = " << h;
    EXPECT_EQ(counted.forces, 1 + report.newton_steps + report.halvings) << "h = " << h;
    halvings += report.halvings;
  }
  EXPECT_GT(halvings, 0);
}

TEST(NewtonEuler, IsOfFirstOrder) {
  const auto end = [](int steps) {
    hair::Simulation simulation(folded_strand(Method::newton_euler, 0.01 / steps));
    EXPECT_FALSE(simulation.advance(steps));
    return simulation.state(0).x;
  };
  const Eigen::VectorXd a = end(800), b = end(1600), c = end(3200);
  EXPECT_NEAR(std::log2((a - b).norm() / (b - c).norm()), 1, 0.15);
}

}  // namespace
}  // namespace reference_tests
