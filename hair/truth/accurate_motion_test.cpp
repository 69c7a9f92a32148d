// STAFF ONLY. Accurate motions equal closed forms, keep energies, and end when they are interrupted. A kept
// motion is the same bit by bit, and belongs to its problem alone.

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <set>

#include "hair/io/files/read_file.h"
#include "hair/scene/scene_run.h"
#include "hair/strand/make_strand.h"
#include "hair/truth/accurate_motion.h"
#include "hair/truth/cvode.h"
#include "hair/truth/space_error.h"
#include "hair/truth/strand_ode.h"
#include "hair/truth/test_problems.h"

namespace reference_tests {
namespace {

using hair::AccurateMotion;
using hair::Problem;

namespace fs = std::filesystem;

// There are a few hundred steps, and each may be off by 1e-12 of the size: 1e-9 allows for their sum.
constexpr double kOff = 1e-9;

const std::atomic<bool> kNever = false;

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
  for (const auto method : {hair::CvodeMethod::adams, hair::CvodeMethod::bdf}) {
    Breaking breaking;
    try {
      hair::run_cvode(breaking, 1, 4, {method, 1e-6}, kNever);
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
  const hair::SpaceError error = hair::space_error(problem, kNever).value();
  ASSERT_EQ(error.levels.size(), 4U) << error.left_out;
  EXPECT_NEAR(error.order, 2, 0.3);
  EXPECT_EQ(error.levels[1].segments, 6);
  for (std::size_t k = 1; k < error.levels.size(); ++k)
    EXPECT_LT(error.levels[k].error, error.levels[k - 1].error / 2)
        << error.levels[k].segments << " segments";
  EXPECT_LT(error.time_error, error.levels.back().error / 100);
}

TEST(SpaceError, IsNotMadeUpWhereThereIsNone) {
  Problem problem = level_strand(1);
  problem.scene.hair.strands[0].state.x[3] += 1e-3;
  const hair::SpaceError error = hair::space_error(problem, kNever).value();
  EXPECT_TRUE(error.levels.empty());
  EXPECT_NE(error.left_out, "");
}

class MotionCache : public ::testing::Test {
 protected:
  MotionCache() { fs::remove_all(folder_); }
  ~MotionCache() override { fs::remove_all(folder_); }
  MotionCache(const MotionCache&) = delete;
  MotionCache& operator=(const MotionCache&) = delete;

  AccurateMotion motion() const {
    return hair::accurate_motion(level_strand(), {1e-6, folder_}, kNever).value();
  }
  fs::path only_file() const {
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 1);
    return fs::directory_iterator(folder_)->path();
  }
  void write(const std::string& bytes) const { std::ofstream(only_file(), std::ios::binary) << bytes; }

  const fs::path folder_ =
      fs::path(::testing::TempDir()) /
      (std::string("motions-") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

void expect_same(const AccurateMotion& a, const AccurateMotion& b) {
  ASSERT_EQ(a.states.size(), b.states.size());
  for (std::size_t k = 0; k < a.states.size(); ++k) {
    EXPECT_EQ(a.states[k].x, b.states[k].x) << "at moment " << k;
    EXPECT_EQ(a.states[k].v, b.states[k].v) << "at moment " << k;
  }
  EXPECT_EQ(a.agreement, b.agreement);
  EXPECT_EQ(a.method, b.method);
  EXPECT_EQ(a.evaluations, b.evaluations);
  EXPECT_EQ(a.inextensible, b.inextensible);
}

TEST_F(MotionCache, GivesBackTheSameBits) {
  const AccurateMotion first = motion();
  EXPECT_FALSE(first.from_cache);
  const AccurateMotion second = motion();
  EXPECT_TRUE(second.from_cache);
  expect_same(first, second);
  EXPECT_EQ(first.cpu_seconds, second.cpu_seconds);
}

// A key contains forces at states that the motion never reaches.
TEST_F(MotionCache, ChangesNothing) {
  Problem hard = level_strand(200);
  hard.duration = 1e-3;  // tensions grow from nothing
  const AccurateMotion alone = hair::accurate_motion(hard, {hair::kTightest, {}}, kNever).value();
  ASSERT_TRUE(alone.inextensible);
  expect_same(alone, hair::accurate_motion(hard, {hair::kTightest, folder_}, kNever).value());
}

// Tolerances as near to each other as people give them.
TEST_F(MotionCache, KnowsTolerancesApart) {
  for (const double tolerance : {1e-6, 1.4e-6, 1.4001e-6})
    EXPECT_FALSE(hair::accurate_motion(level_strand(), {tolerance, folder_}, kNever)->from_cache)
        << tolerance;
}

TEST_F(MotionCache, BelievesNoFileThatIsNotWhole) {
  const AccurateMotion first = motion();
  const std::string bytes = hair::bytes_of(only_file());
  ASSERT_GT(bytes.size(), 1000U);
  std::string flipped = bytes;
  flipped[bytes.size() / 2] = flipped[bytes.size() / 2] == '1' ? '2' : '1';
  for (const std::string& bad : {flipped, bytes.substr(0, bytes.size() / 2), bytes + "1", std::string(),
                                 std::string("something else")}) {
    write(bad);
    const AccurateMotion again = motion();
    EXPECT_FALSE(again.from_cache) << bad.size() << " bytes";
    expect_same(first, again);
    EXPECT_TRUE(motion().from_cache) << "written again";
  }
}

TEST_F(MotionCache, IsNoneWhereItCannotBe) {
  std::ofstream(folder_) << "a file";
  EXPECT_FALSE(motion().from_cache);
  EXPECT_FALSE(motion().from_cache);
}

TEST(MotionKey, ChangesWithAllThatAMotionDependsOn) {
  const auto key_of = [](const Problem& problem, const std::string& method = "method") {
    hair::StrandOde ode(problem);
    return hair::motion_key(problem, ode, method);
  };
  const std::string key = key_of(carried_strand());
  EXPECT_EQ(key_of(carried_strand()), key);
  std::set<std::string> keys = {key, key_of(carried_strand(), "other")};
  const std::vector<std::function<void(Problem&)>> changes = {
      [](Problem& p) { p.duration *= 1.5; },
      [](Problem& p) { p.scene.frames = 8; },
      [](Problem& p) { p.scene.hair.gravity[2] = -9.82; },
      [](Problem& p) { p.scene.hair.drag = 1e-5; },
      [](Problem& p) { p.scene.hair.strands[0].strand.mass[3] *= 1.01; },
      [](Problem& p) { p.scene.hair.strands[0].strand.rest_length[3] *= 1.01; },
      [](Problem& p) { p.scene.hair.strands[0].strand.bend_rigidity *= 1.01; },
      [](Problem& p) { p.scene.hair.strands[0].strand.stretch_rigidity *= 1.01; },
      [](Problem& p) { p.scene.hair.strands[0].strand.skip_rigidity = 1; },
      [](Problem& p) { p.scene.hair.strands[0].strand.clamped = false; },
      [](Problem& p) { p.scene.hair.strands[0].state.x[7] += 1e-9; },
      [](Problem& p) { p.scene.hair.strands[0].state.v[7] += 1e-9; },
      [](Problem& p) { p.scene.riders[0].motion.keys[1].time += 1e-9; },
      [](Problem& p) { p.scene.riders[0].motion.keys[1].pose.position[1] += 1e-9; },
      [](Problem& p) { p.scene.riders.clear(); },
  };
  for (const auto& change : changes) {
    Problem other = carried_strand();
    change(other);
    keys.insert(key_of(other));
  }
  EXPECT_EQ(keys.size(), changes.size() + 2);
}

// The same problem with forces of other code.
TEST(MotionKey, ChangesWithTheForces) {
  const Problem problem = level_strand();
  Problem bent = problem;
  bent.scene.hair.strands[0].strand.bend_rigidity *= 1 + 1e-6;  // no force at the start: it is straight
  hair::StrandOde forces(problem), others(bent);
  EXPECT_NE(hair::motion_key(problem, forces, "method"), hair::motion_key(problem, others, "method"));
}

}  // namespace
}  // namespace reference_tests
