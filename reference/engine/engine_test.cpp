// STAFF ONLY. The engine against given code with the reference's exercises, and its own promises.

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <bit>
#include <limits>
#include <numbers>
#include <vector>

#include "hair/length_correction.h"
#include "hair/predictor_corrector.h"
#include "hair/strand/measures.h"
#include "hair/strand/obstacles.h"
#include "hair/strand/variation.h"
#include "particles/implicit_euler.h"
#include "reference/engine/distance_grid.h"
#include "reference/engine/head_of_strands.h"
#include "solver/tests/allocations.h"

namespace hair::engine {
namespace {

using Eigen::VectorXd;

constexpr double kUnit = 0x1p-53;

struct InstructionSet {
  const char* name;
  long long disabled;  // of Highway's targets
};

// Each test runs with each of the kernels that this processor can run.
class Engine : public testing::TestWithParam<InstructionSet> {
 public:
  void SetUp() override { use(GetParam().disabled); }
  void TearDown() override { use(0); }

 private:
  static void use(long long disabled) {
    hwy::DisableTargets(disabled);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
};

INSTANTIATE_TEST_SUITE_P(, Engine,
                         testing::Values(InstructionSet{"best", 0},
                                         InstructionSet{"avx2", HWY_AVX3_DL | HWY_AVX3},
                                         InstructionSet{"scalar", ~0LL}),
                         [](const testing::TestParamInfo<InstructionSet>& set) { return set.param.name; });

class Ball : public Solid {
 public:
  explicit Ball(double radius) : radius_(radius) {}
  Surface surface_at(const Vector3d& point) const override {
    const double distance = point.norm();
    return {distance - radius_, distance > 0 ? Vector3d(point / distance) : Vector3d::UnitZ()};
  }
  Eigen::AlignedBox3d box() const override {
    return {Vector3d::Constant(-radius_), Vector3d::Constant(radius_)};
  }

 private:
  double radius_;
};

Vector3d some_direction(Variation& random) {
  for (;;) {
    const Vector3d d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    if (d.norm() > 0.1 && d.norm() < 1) return d.normalized();
  }
}

// A strand on a ball, bent at random and moving.
struct Start {
  double rest_length;
  Vector3d tangent;
  VectorXd x, v;
};

constexpr double kBall = 0.1;

Start some_start(int points, std::uint64_t seed, double bend = 0.4, double speed = 1) {
  Variation random(seed, points);
  Start start;
  start.rest_length = random.uniform(0.006, 0.012);
  start.tangent = some_direction(random);
  start.x.resize(3 * points);
  start.v.resize(3 * points);
  start.x.head<3>() = kBall * start.tangent;
  start.v.head<3>().setZero();
  Vector3d along = start.tangent;
  for (int i = 1; i < points; ++i) {
    along = (along + bend * some_direction(random)).normalized();
    start.x.segment<3>(3 * i) =
        start.x.segment<3>(3 * i - 3) + start.rest_length * (1 + random.uniform(-1e-4, 1e-4)) * along;
    start.v.segment<3>(3 * i) = speed * some_direction(random);
  }
  return start;
}

// Lengths that fill groups, and that do not; the shortest and a long one.
const std::vector<int> kPoints = {25, 2, 25, 3, 25, 4, 25, 25, 200, 25, 25, 25, 25, 5, 25, 3, 25};

std::vector<Start> starts(double bend = 0.4, double speed = 1) {
  std::vector<Start> all;
  for (std::size_t k = 0; k < kPoints.size(); ++k) all.push_back(some_start(kPoints[k], k, bend, speed));
  return all;
}

void set(FullHead& head, const std::vector<Start>& all) {
  for (std::size_t k = 0; k < all.size(); ++k)
    head.set_strand(static_cast<int>(k), all[k].rest_length, all[k].tangent, all[k].x, all[k].v);
}

particles::State state(const FullHead& head, int k) {
  const int size = 3 * kPoints[k % kPoints.size()];
  particles::State s{VectorXd(size), VectorXd(size)};
  head.get_strand(k, s.x, s.v);
  return s;
}

std::vector<particles::State> after(const FullHeadSettings& settings, const std::vector<Start>& all, double h,
                                    const Eigen::Isometry3d& pose = Eigen::Isometry3d::Identity()) {
  FullHead head(kPoints, settings);
  set(head, all);
  head.step(h, pose);
  std::vector<particles::State> states;
  for (int k = 0; k < head.strands(); ++k) states.push_back(state(head, k));
  EXPECT_EQ(head.broken(), 0);
  return states;
}

FullHeadSettings bare() {
  FullHeadSettings settings;
  settings.drag = 2;
  settings.wind = {3, -1, 0.5};
  settings.bending = settings.correct_lengths = false;
  return settings;
}

// What the engine's dv leaves of H4's equation in given code. A residual of rounding: with the matrix' norm N, each of its
// numbers is a sum of at most 15 products of some ten roundings each, and is multiplied by velocities: those of the solution, those before, and
// what rounding of positions makes of velocities, u |x| / h. The forces' own rounding, h k u |x|, is less than N u |x| / h.
void expect_solved(const FullHeadSettings& settings, const std::vector<Start>& all, double h,
                   const Vector3d& root_velocity = Vector3d::Zero()) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = h * root_velocity;
  const auto states = after(settings, all, h, pose);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto moving = given_strand(settings, kPoints[k], all[k].rest_length, all[k].tangent);
    particles::State before{all[k].x, all[k].v};
    before.v.head<3>() = root_velocity;
    const auto& after = states[k];
    const Eigen::Index size = before.x.size();

    VectorXd rhs = VectorXd::Zero(size), dv = after.v - before.v, product(size), moved = h * before.v;
    moving->force.add_force(before.x, before.v, rhs);
    moving->force.add_dfdx(before.x, before.v, moved, rhs);
    rhs *= h;
    const auto matrix = particles::implicit_matrix(moving->force, moving->particles, before, h, h);
    matrix->matVecMult(dv.data(), product.data());
    Eigen::MatrixXd scratch(size, particles::kPreconditionerScratch);
    const particles::Preconditioner band(moving->force, moving->particles, before, h, h, scratch);
    ASSERT_TRUE(band.exists());

    const double residual = (rhs - product).tail(size - 3).norm();
    const double speeds = dv.norm() + before.v.norm() + after.x.cwiseAbs().maxCoeff() / h * std::sqrt(size);
    const double bound = 150 * kUnit * (band.norm() * speeds + rhs.norm());
    EXPECT_LE(residual, bound) << "strand " << k << " of " << kPoints[k] << " points, |rhs| " << rhs.norm();
    EXPECT_LE((after.x - before.x - h * after.v).cwiseAbs().maxCoeff(),
              4 * kUnit * (after.x.cwiseAbs().maxCoeff() + h * after.v.cwiseAbs().maxCoeff()));
  }
}

TEST_P(Engine, SolvesGivenCodesEquationOfStretching) {
  expect_solved(bare(), starts(), 1.0 / 240);
}

TEST_P(Engine, SolvesGivenCodesEquationWithBending) {
  FullHeadSettings settings = bare();
  settings.bending = true;
  expect_solved(settings, starts(), 1.0 / 240);
  expect_solved(settings, starts(0), 1.0 / 240);  // straight: angles of rounding
  expect_solved(settings, starts(5), 1.0 / 240);  // angles up to pi
  expect_solved(settings, starts(1e-5), 1.0 / 240);
  settings.clamped = false;
  expect_solved(settings, starts(), 1.0 / 240);
}

TEST_P(Engine, SolvesStiffHairInShortAndLongSteps) {
  FullHeadSettings settings = bare();
  settings.bending = true;
  for (const double times : {1.0, 1e4})
    for (const double h : {1.0 / 960, 1.0 / 60, 1.0 / 24}) {
      settings.material.young_modulus = 3e9 * times;
      SCOPED_TRACE(testing::Message() << times << " times hair's EA, h " << h);
      expect_solved(settings, starts(), h);
      expect_solved(settings, starts(), h, {100, 0, 0});  // flung away
    }
}

// A joint that is folded, and a segment of length 0: neither has a direction to turn to.
TEST_P(Engine, TakesFoldsAndVanishedSegmentsAsGivenCodeDoes) {
  FullHeadSettings settings = bare();
  settings.bending = true;
  auto all = starts(0, 0);
  for (auto& start : all)
    for (Eigen::Index i = 0; i < start.x.size(); i += 3)
      start.x.segment<3>(i) = Vector3d(0.01 * double(i % 2), 0, 0);
  expect_solved(settings, all, 1.0 / 240);
  for (auto& start : all)
    for (Eigen::Index i = 0; i < start.x.size(); i += 3)
      start.x.segment<3>(i) = Vector3d(0.01 * double(i > 6), 0, 0);
  expect_solved(settings, all, 1.0 / 240);
}

// From the same positions, both corrections end with lengths that are right to 1e-12. What they may differ by is an error C of
// lengths, which moves points by W J^T (J W J^T)^-1 C, and the smallest singular value of a hanging strand's J is about
// pi / 2n.
TEST_P(Engine, CorrectsLengthsAndVelocitiesAsGivenCodeDoes) {
  constexpr double h = 1.0 / 240;
  FullHeadSettings settings = bare();
  const auto all = starts();
  const auto uncorrected = after(settings, all, h);
  settings.correct_lengths = true;
  const auto corrected = after(settings, all, h);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto moving = given_strand(settings, kPoints[k], all[k].rest_length, all[k].tangent);
    particles::State expected = uncorrected[k];
    Eigen::MatrixXd scratch(expected.x.size(), kCorrectionScratch);
    const auto report =
        correct_lengths(moving->strand, kLengthTolerance, kMostCorrections, expected.x, scratch);
    ASSERT_TRUE(report.converged);
    EXPECT_GE(report.iterations, kPoints[k] > 3 ? 2 : 1);
    expected.v += (expected.x - uncorrected[k].x) / h;
    const double n = kPoints[k], bound = 4 * n * std::sqrt(n) * kLengthTolerance * all[k].rest_length;
    EXPECT_LE(largest_stretch(moving->strand, corrected[k].x), 1.01 * kLengthTolerance) << "strand " << k;
    EXPECT_LE((corrected[k].x - expected.x).norm(), bound) << "strand " << k << ", " << n << " points";
    EXPECT_LE((corrected[k].v - expected.v).norm(), bound / h) << "strand " << k;
  }
}

// Newton's method gives way to `place` where hair is torn or flung: lengths are right all the same.
TEST_P(Engine, CorrectsTheLengthsOfFlungHair) {
  FullHeadSettings settings;
  for (const double h : {1.0 / 960, 1.0 / 60, 1.0 / 24}) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = Vector3d(100 * h, 0, 0);
    const auto all = starts(0.4, 10);
    const auto states = after(settings, all, h, pose);
    for (std::size_t k = 0; k < all.size(); ++k) {
      const auto moving = given_strand(settings, kPoints[k], all[k].rest_length, all[k].tangent);
      EXPECT_LE(largest_stretch(moving->strand, states[k].x), 1e-11) << "strand " << k << ", h " << h;
    }
  }
}

TEST_P(Engine, PushesHairOutOfTheHeadAsGivenCodeDoes) {
  constexpr double h = 1.0 / 240;
  FullHeadSettings settings = bare();
  settings.correct_lengths = true;
  settings.friction = 0.3;
  const auto all = starts(0.8, 2);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  const Vector3d velocity(0.5, 0.2, -0.1);
  pose.translation() = h * velocity;
  const auto free = after(settings, all, h, pose);
  settings.head = std::make_shared<Ball>(kBall);
  const auto states = after(settings, all, h, pose);
  const std::vector<Obstacle> obstacles = {
      {PlacedSolid{std::make_shared<DistanceGrid>(*settings.head, settings.grid_spacing), h * velocity},
       settings.friction, velocity}};
  int contacts = 0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto moving = given_strand(settings, kPoints[k], all[k].rest_length, all[k].tangent);
    particles::State expected = free[k];
    contacts += collide(obstacles, moving->particles, h, all[k].x, expected).contacts;
    // Given code goes on until a point is within rounding; normals differ by less than 1 in what is left.
    EXPECT_LE((states[k].x - expected.x).cwiseAbs().maxCoeff(), 3 * kContactDepth) << "strand " << k;
    EXPECT_LE((states[k].v - expected.v).cwiseAbs().maxCoeff(), 1e-3) << "strand " << k;
    for (int i = 1; i < kPoints[k]; ++i)
      EXPECT_GE(surface_at(obstacles[0], states[k].x.segment<3>(3 * i)).distance, -1.01 * kContactDepth);
  }
  EXPECT_GT(contacts, 10);
}

FullHeadSettings everything() {
  FullHeadSettings settings = bare();
  settings.bending = settings.correct_lengths = true;
  settings.head = std::make_shared<Ball>(kBall);
  settings.friction = 0.3;
  settings.grid_spacing = 1e-2;
  return settings;
}

Eigen::Isometry3d pose_at(double t) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::AngleAxisd(std::sin(6 * t), Vector3d::UnitZ()).toRotationMatrix();
  pose.translation() = Vector3d(0.05 * std::sin(9 * t), 0, 0);
  return pose;
}

void run(FullHead& head, int steps, double h = 1.0 / 120) {
  for (int i = 1; i <= steps; ++i) head.step(h, pose_at(i * h));
}

bool same_bits(const VectorXd& a, const VectorXd& b) {
  for (Eigen::Index i = 0; i < a.size(); ++i)
    if (std::bit_cast<std::uint64_t>(a[i]) != std::bit_cast<std::uint64_t>(b[i])) return false;
  return true;
}

// Enough strands for both threads to be at work at once.
TEST_P(Engine, GivesTheSameBitsWithOneThreadAndTwo) {
  std::vector<int> points;
  std::vector<Start> all;
  for (int k = 0; k < 2000; ++k) {
    points.push_back(kPoints[k % kPoints.size()]);
    all.push_back(some_start(points.back(), k));
  }
  FullHeadSettings settings = everything();
  FullHead one(points, settings);
  settings.threads = 2;
  FullHead two(points, settings);
  set(one, all);
  set(two, all);
  run(one, 10);
  run(two, 10);
  for (int k = 0; k < one.strands(); ++k) {
    EXPECT_TRUE(same_bits(state(one, k).x, state(two, k).x)) << "strand " << k;
    EXPECT_TRUE(same_bits(state(one, k).v, state(two, k).v)) << "strand " << k;
  }
}

// A strand alone, and among others, one of which has no numbers.
TEST_P(Engine, KeepsNansInTheirStrandAndSaysWhich) {
  constexpr int kLost = 4;
  FullHead head(kPoints, everything());
  auto all = starts();
  all[kLost].x[20] = std::numeric_limits<double>::quiet_NaN();
  all[8].v[500] = std::numeric_limits<double>::infinity();
  set(head, all);
  run(head, 20);
  EXPECT_EQ(head.broken(), 2);
  EXPECT_EQ(head.broke_at(kLost), 1);
  EXPECT_EQ(head.broke_at(8), 1);
  for (int k = 0; k < head.strands(); ++k) {
    if (k == kLost || k == 8) continue;
    FullHead alone(std::vector<int>{kPoints[k]}, everything());
    alone.set_strand(0, all[k].rest_length, all[k].tangent, all[k].x, all[k].v);
    run(alone, 20);
    particles::State expected{VectorXd(3 * kPoints[k]), VectorXd(3 * kPoints[k])};
    alone.get_strand(0, expected.x, expected.v);
    EXPECT_TRUE(same_bits(state(head, k).x, expected.x)) << "strand " << k;
  }
}

TEST_P(Engine, HoldsStiffHairOnAHeadThatShakes) {
  FullHeadSettings settings = everything();
  for (const double times : {1.0, 1e4})
    for (const double h : {1.0 / 960, 1.0 / 24}) {
      settings.material.young_modulus = 3e9 * times;
      FullHead head(kPoints, settings);
      set(head, starts());
      run(head, 48, h);
      EXPECT_EQ(head.broken(), 0);
      for (int k = 0; k < head.strands(); ++k)
        EXPECT_LE(state(head, k).v.cwiseAbs().maxCoeff(), 30) << times << ", h " << h << ", strand " << k;
    }
}

TEST_P(Engine, AllocatesNothingInAStep) {
  FullHeadSettings settings = everything();
  settings.threads = 2;
  FullHead head(kPoints, settings);
  set(head, starts());
  const long before = reference_tests::allocations();
  run(head, 3);
  EXPECT_EQ(reference_tests::allocations(), before);
}

TEST_P(Engine, RefusesWhatItCannotDo) {
  FullHead head(kPoints, {});
  EXPECT_THROW(head.step(0.01), std::invalid_argument);
  EXPECT_THROW(FullHead(std::vector<int>{1}, {}), std::invalid_argument);
  const Start start = some_start(25, 1);
  EXPECT_THROW(head.set_strand(1, 0.01, start.tangent, start.x, start.v), std::invalid_argument);
  EXPECT_THROW(head.set_strand(0, 0, start.tangent, start.x, start.v), std::invalid_argument);
  EXPECT_THROW(head.set_strand(0, 0.01, 2 * start.tangent, start.x, start.v), std::invalid_argument);
}

}  // namespace
}  // namespace hair::engine
