// STAFF ONLY. Human hair, 30 cm in 30 segments, swings under gravity: its stretch with H4 and H6, and the
// effect of the solver's tolerance. Swings across the hair and their limit are in hair/lab/validate and
// hair/lab/stability.

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

#include "handout/check/implicit_systems.h"
#include "reference/H6/stepping_for_tests.h"

namespace reference_tests {
namespace {

using hair::GeometricTerm;
using hair::Strand;

struct Swing {
  double length = 0;  // the largest |l - l0| / l0
  double rate = 0;    // the largest velocity along a segment, m/s
  double energy = 0;  // the largest gain of kinetic and potential energy over m g L
};

// Lets a hair swing for a second, from level and at rest.
template <typename Step>
Swing swing(GeometricTerm term, double h, Step step) {
  const Strand strand = human_hair();
  Hair hair(strand, term);
  hair.place(Vector3d::UnitX());
  Swing result;
  const double unit = strand.mass.sum() * kGravity * 0.3;
  for (int i = 0; i < std::lround(1 / h); ++i) {
    step(hair, h);
    EXPECT_TRUE(hair.state.x.allFinite() && hair.state.v.allFinite());
    result.length = std::max(result.length, hair::largest_stretch(strand, hair.state.x));
    result.rate = std::max(result.rate, largest_rate(strand, hair.state.x, hair.state.v));
    double energy = 0;  // it starts with none
    for (int j = 0; j <= 30; ++j)
      energy += strand.mass[j] *
                (0.5 * hair.state.v.segment<3>(3 * j).squaredNorm() + kGravity * hair.state.x[3 * j + 2]);
    result.energy = std::max(result.energy, energy / unit);
  }
  return result;
}

// A chaotic motion depends on rounding, and so on the way systems are solved. The expected numbers are those
// without a preconditioner.
void implicit(Hair& hair, double h) {
  hair.force.hide_band();
  hair.implicit_step(h);
}

TEST(SwingingHair, PredictorCorrectorKeepsEverySegmentsLength) {
  for (double h : {1.0 / 60, 1.0 / 240, 1.0 / 960}) {
    int iterations = 0;
    const Swing result = swing(GeometricTerm::filtered, h, [&](Hair& hair, double step) {
      const hair::StepReport report = hair.corrected_step(step);
      EXPECT_TRUE(report.correction.converged);
      iterations += report.correction.iterations;
    });
    EXPECT_LE(result.length, 1e-10) << "h = " << h;
    EXPECT_LE(result.rate, 1e-4) << "h = " << h;
    EXPECT_LE(result.energy, 1e-3) << "h = " << h;
    // At 1/60 s the hair swings faster across itself than the step allows, 6.3 ms.
    EXPECT_LE(iterations * h, h < 1 / 100.0 ? 3.5 : 10) << "iterations of the correction a step, h = " << h;
  }
}

TEST(SwingingHair, LinearlyImplicitEulerStretchesIt) {
  const double steps[] = {1.0 / 60, 1.0 / 240, 1.0 / 960};
  for (GeometricTerm term : {GeometricTerm::full, GeometricTerm::filtered}) {
    const bool full = term == GeometricTerm::full;
    const double lengths[] = {0.6784, full ? 0.0427 : 0.0422, 3.70e-4};
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(swing(term, steps[i], implicit).length, lengths[i], 0.02 * lengths[i]) << steps[i];
  }
  // A hair that gets far too long moves chaotically: rounding decides how long.
  EXPECT_GT(swing(GeometricTerm::dropped, steps[0], implicit).length, 10);
  EXPECT_GT(swing(GeometricTerm::dropped, steps[1], implicit).length, 1);
  EXPECT_NEAR(swing(GeometricTerm::dropped, steps[2], implicit).length, 0.1534, 0.02 * 0.1534);
}

// One pass from the root to the tip gets every length right, too, if it shifts the rest of the hair. But it
// ignores masses, and adds energy.
TEST(SwingingHair, OnePassAloneAddsEnergy) {
  const auto one_pass = [](Hair& hair, double h) {
    auto scratch = hair.scratch.leftCols(particles::kImplicitScratch);
    VectorXd dv(hair.state.x.size());
    particles::State& state = hair.state;
    solve_implicit(hair.force, hair.particles, state, h / 2, h, 1e-10, dv, scratch);
    state.v += dv;
    state.x += h * state.v;
    const VectorXd predicted = state.x;
    for (int i = 0; i < hair.strand.segments(); ++i)
      state.x.segment<3>(3 * i + 3) =
          state.x.segment<3>(3 * i) + hair.strand.rest_length[i] * segment(predicted, i).normalized();
    state.v += (state.x - predicted) / h;
    solve_implicit(hair.force, hair.particles, state, h / 2, h, 1e-10, dv, scratch);
    state.v += dv;
  };
  const Swing result = swing(GeometricTerm::filtered, 1.0 / 960, one_pass);
  EXPECT_LE(result.length, 1e-12);
  EXPECT_NEAR(result.energy, 0.16, 0.01) << "of m g L";
}

// Measures dv's error at looser tolerances, along a swing that is computed with 1e-10.
TEST(SwingingHair, NeedsATightTolerance) {
  const double h = 1.0 / 240;
  const Strand strand = human_hair();
  Hair hair(strand, GeometricTerm::full);
  hair.force.hide_band();  // with a preconditioner even 1e-2 gets near the solution
  hair.place(Vector3d::UnitX());
  const double tolerances[] = {1e-10, 1e-6, 1e-4};
  std::vector<double> errors[3];
  for (int i = 0; i < 120; ++i) {
    const MatrixXd A = checks::table(hair.force, hair.particles, hair.state, h, h);
    VectorXd rhs(93);
    implicit_rhs(hair.force, hair.particles, hair.state, h, h, rhs);
    const Eigen::LDLT<MatrixXd> factors(A);
    VectorXd exact = factors.solve(rhs);
    exact += factors.solve(rhs - A * exact);
    for (int t = 0; t < 3; ++t) {
      VectorXd dv(93);
      auto scratch = hair.scratch.leftCols(particles::kImplicitScratch);
      solve_implicit(hair.force, hair.particles, hair.state, h, h, tolerances[t], dv, scratch);
      errors[t].push_back((dv - exact).cwiseAbs().maxCoeff());
    }
    hair.implicit_step(h);
  }
  const auto worst = [](const std::vector<double>& values) {
    return *std::max_element(values.begin(), values.end());
  };
  EXPECT_LE(worst(errors[0]), 1e-5) << "m/s at 1e-10";
  EXPECT_NEAR(worst(errors[1]), 3e-2, 2e-2) << "m/s at 1e-6";
  std::nth_element(errors[2].begin(), errors[2].begin() + 60, errors[2].end());
  EXPECT_NEAR(errors[2][60], kGravity * h, 0.1 * kGravity * h)
      << "m/s at 1e-4: in half of the steps gravity is lost";
}

}  // namespace
}  // namespace reference_tests
