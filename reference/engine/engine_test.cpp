// STAFF ONLY. The engine against given code with the reference's exercises.

#include <cmath>

#include "hair/length_correction.h"
#include "hair/predictor_corrector.h"
#include "hair/strand/measures.h"
#include "particles/implicit_euler.h"
#include "reference/engine/engine_states.h"

namespace hair::engine {
namespace {

INSTANTIATE_TEST_SUITE_P(, Engine,
                         testing::Values(InstructionSet{"best", 0}, InstructionSet{"avx2", kAvx512},
                                         InstructionSet{"scalar", ~0LL}),
                         [](const testing::TestParamInfo<InstructionSet>& set) { return set.param.name; });

// Puts the engine's dv into H4's equation in given code: only rounding is left as a residual. Let N be the
// matrix' norm. Each of its numbers is a sum of at most 15 products of some ten roundings each, and is
// multiplied by velocities: the solution's, those before, and u |x| / h from rounded positions. The forces'
// own rounding, h k u |x|, is less than N u |x| / h. The head turns in the step: the clamp's tangent is that
// at its end, and each root has a velocity of its own.
void expect_solved(const FullHeadSettings& settings, const std::vector<Start>& all, double h,
                   const Eigen::Isometry3d& pose = turned_head(0.3, Vector3d(2e-3, -5e-3, 1e-3))) {
  const auto states = after(settings, all, h, pose);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto moving =
        given_strand(settings, kPoints[k], all[k].rest_length, pose.linear() * all[k].tangent);
    particles::State before{all[k].x, all[k].v};
    const Vector3d root = before.x.head<3>();
    before.v.head<3>() = (pose * root - root) / h;
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
    const double bound = residual_bound(band.norm(), rhs.norm(), before, after, h);
    EXPECT_LE(residual, bound) << "strand " << k << " of " << kPoints[k] << " points, |rhs| " << rhs.norm();
    EXPECT_LE((after.x - before.x - h * after.v).cwiseAbs().maxCoeff(),
              4 * 0x1p-53 * (after.x.cwiseAbs().maxCoeff() + h * after.v.cwiseAbs().maxCoeff()));
  }
}

TEST_P(Engine, SolvesGivenCodesEquationOfStretching) {
  expect_solved(bare(), starts(), 1.0 / 240);
}

TEST_P(Engine, SolvesGivenCodesEquationWithBending) {
  FullHeadSettings settings = bare();
  settings.bending = true;
  expect_solved(settings, starts(), 1.0 / 240);
  expect_solved(settings, starts(0), 1.0 / 240, turned_head(0));  // straight: angles of rounding
  expect_solved(settings, starts(0), 1.0 / 240);
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
      expect_solved(settings, starts(), h, turned_head(0, Vector3d(100 * h, 0, 0)));  // flung away
    }
}

// A folded joint and a segment of length 0 have no direction to turn to.
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

// From the same positions, both corrections end with lengths that are right to 1e-12. They may differ by an
// error C of lengths, which moves points by W J^T (J W J^T)^-1 C. The smallest singular value of a hanging
// strand's J is about pi / 2n.
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

// With so many right angles the product of all pivots is 2^3000, more than a double holds. Given code has no
// such product.
TEST_P(Engine, CorrectsTheLengthsOfManyRightAngles) {
  constexpr int kMany = 3000;
  constexpr double h = 1e-3, l0 = 0.01;
  FullHeadSettings settings = bare();
  settings.gravity = settings.wind = Vector3d::Zero();
  settings.material.young_modulus = 1e-6;  // lengths stay wrong until they are corrected
  const auto moving = given_strand(settings, kMany, l0, Vector3d::UnitX());
  VectorXd x = VectorXd::Zero(3 * kMany), v = x;
  for (int i = 1; i < kMany; ++i)
    x.segment<3>(3 * i) = x.segment<3>(3 * i - 3) + 1.001 * l0 * Vector3d::Unit(i % 2);
  FullHead head(std::vector<int>{kMany}, [&] {
    settings.correct_lengths = true;
    return settings;
  }());
  head.set_strand(0, l0, Vector3d::UnitX(), x, v);
  head.step(h);
  particles::State after{x, v};
  head.get_strand(0, after.x, after.v);
  Eigen::MatrixXd scratch(3 * kMany, kCorrectionScratch);
  ASSERT_TRUE(correct_lengths(moving->strand, kLengthTolerance, kMostCorrections, x, scratch).converged);
  // H5's bound for what rounding allows is above its tolerance here.
  const double tolerance = std::max(kLengthTolerance, 0x1p-51 * (x.cwiseAbs().maxCoeff() / l0 + kMany));
  EXPECT_LE((after.x - x).norm(), 4 * kMany * std::sqrt(kMany) * tolerance * l0);
  EXPECT_LE(largest_stretch(moving->strand, after.x), 1.01 * tolerance);
}

}  // namespace
}  // namespace hair::engine
