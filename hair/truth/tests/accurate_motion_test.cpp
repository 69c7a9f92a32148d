// STAFF ONLY. Accurate motions equal closed forms, keep energies, and end when they are interrupted.
#include "hair/truth/accurate_motion.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>

#include "hair/scene/scene_run.h"
#include "hair/strand/make_strand.h"
#include "hair/truth/cvode.h"
#include "hair/truth/space_error.h"
#include "problems.h"

namespace reference_tests {
namespace {

using hair::AccurateMotion;
using hair::Problem;

// There are a few hundred steps, and each may be off by 1e-12 of the size: 1e-9 allows for their sum.
constexpr double kOff = 1e-9;

TEST(AccurateMotion, OfADampedSpringIsTheClosedForm) {
  constexpr double kMass = 0.1, kStiffness = 40, kDamping = 0.5, kAway = 0.2;
  particles::Toy toy;
  toy.particles = {Eigen::Vector2d(1, kMass), {1, 0}};
  toy.start.x = toy.start.v = Eigen::VectorXd::Zero(6);
  toy.start.x[3] = 1 + kAway;
  toy.springs = {{0, 1, kStiffness, 1, kDamping}};
  toy.gravity.setZero();
  hair::Scene scene;
  scene.name = "spring";
  scene.toys = {toy};
  const Problem problem = hair::make_problem(scene, {.strand = 0, .duration = 1.0, .segments = {}});
  const AccurateMotion motion = motion_of(problem);
  const double decay = kDamping / (2 * kMass), omega = std::sqrt(kStiffness / kMass - decay * decay);
  for (int k = 0; k <= hair::kMoments; ++k) {
    const double t = 1.0 * k / hair::kMoments;
    const double expected =
        1 + kAway * std::exp(-decay * t) * (std::cos(omega * t) + decay / omega * std::sin(omega * t));
    EXPECT_NEAR(motion.states.at(k).x[3], expected, kOff) << "at " << t << " s";
  }
  EXPECT_LE(motion.agreement, kOff);
}

TEST(AccurateMotion, KeepsTheEnergyWithoutDrag) {
  const Problem problem = level_strand();
  const hair::SceneRun scene_run(problem.scene);
  const AccurateMotion motion = motion_of(problem);
  const double start = scene_run.measure(motion.states.front()).energy();
  const double kinetic = scene_run.measure(motion.states.back()).kinetic;
  ASSERT_GT(kinetic, 0);
  EXPECT_LE(std::abs(scene_run.measure(motion.states.back()).energy() - start), 1e-8 * kinetic)
      << "with a kinetic energy of " << kinetic << " J";
}

// y' = -y, interrupted at the 20th evaluation.
class Interrupting : public hair::Ode {
 public:
  explicit Interrupting(std::atomic<bool>& interrupted) : interrupted_(interrupted) {}
  int size() const override { return 1; }
  Eigen::VectorXd start() const override { return Eigen::VectorXd::Ones(1); }
  Eigen::VectorXd scales() const override { return Eigen::VectorXd::Ones(1); }
  void rates(double, particles::Input y, particles::Output dy) override {
    if (++calls_ == 20) interrupted_ = true;
    dy = -y;
  }
  particles::State state(double, particles::Input y) override { return {y, y}; }
  long calls() const { return calls_; }

 private:
  std::atomic<bool>& interrupted_;
  long calls_ = 0;
};

TEST(AccurateMotion, AsksForNothingMoreOnceItIsInterrupted) {
  for (const auto method : {hair::CvodeMethod::adams, hair::CvodeMethod::bdf}) {
    std::atomic<bool> interrupted = false;
    Interrupting ode(interrupted);
    EXPECT_FALSE(hair::run_cvode(ode, 10, 4, {method, 1e-9}, interrupted));
    EXPECT_EQ(ode.calls(), 20);
  }
  const std::atomic<bool> already = true;
  EXPECT_FALSE(hair::accurate_motion(level_strand(), {}, already));
}

// y' = 1 until t = 1/2, and not a number from there on.
class Breaking : public hair::Ode {
 public:
  int size() const override { return 1; }
  Eigen::VectorXd start() const override { return Eigen::VectorXd::Zero(1); }
  Eigen::VectorXd scales() const override { return Eigen::VectorXd::Ones(1); }
  void rates(double t, particles::Input, particles::Output dy) override {
    dy[0] = t < 0.5 ? 1 : std::numeric_limits<double>::quiet_NaN();
  }
  particles::State state(double, particles::Input y) override { return {y, y}; }
};

TEST(AccurateMotion, SaysInALineWhereForcesAreNoNumbers) {
  const std::atomic<bool> interrupted = false;
  for (const auto method : {hair::CvodeMethod::adams, hair::CvodeMethod::bdf}) {
    Breaking breaking;
    try {
      hair::run_cvode(breaking, 1, 4, {method, 1e-6}, interrupted);
      ADD_FAILURE() << "no exception";
    } catch (const std::runtime_error& error) {
      const std::string said = error.what();
      EXPECT_NE(said.find(" 0.5 s"), std::string::npos) << said;
      EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    }
  }
}

TEST(SpaceError, OfAStrandIsOfSecondOrder) {
  Problem problem = level_strand(1);
  problem.scene.hair.strands[0].strand.bend_rigidity *= 5;
  const std::atomic<bool> interrupted = false;
  const hair::SpaceError error = hair::space_error(problem, interrupted).value();
  ASSERT_EQ(error.levels.size(), 4U) << error.left_out;
  EXPECT_NEAR(error.order, 2, 0.3);
  EXPECT_EQ(error.levels[1].segments, 6);
  for (std::size_t k = 1; k < error.levels.size(); ++k)
    EXPECT_LT(error.levels[k].error, error.levels[k - 1].error / 2)
        << error.levels[k].segments << " segments";
  EXPECT_LT(error.time_error, error.levels.back().error / 100);
}

TEST(SpaceError, IsNotMadeUpWhereThereIsNone) {
  const std::atomic<bool> interrupted = false;
  Problem problem = level_strand(1);
  problem.scene.hair.strands[0].state.x[3] += 1e-3;
  const hair::SpaceError error = hair::space_error(problem, interrupted).value();
  EXPECT_TRUE(error.levels.empty());
  EXPECT_NE(error.left_out, "");
}

}  // namespace
}  // namespace reference_tests
