// STAFF ONLY. Human hair, 30 cm in 30 segments, swings under gravity: its stretch with H4 and H6, the
// effect of the solver's tolerance, and the fastest swing across itself.

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

#include "reference/H6/stepping_for_tests.h"
#include "solver/symmetric_eigen.h"

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
    result.length = std::max(result.length, largest_error(strand, hair.state.x));
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
    // At 1/60 s the hair swings faster across itself than the step allows, see below.
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
  // A hair that gets far too long moves chaotically.
  EXPECT_NEAR(swing(GeometricTerm::dropped, steps[0], implicit).length, 42, 0.2 * 42);
  EXPECT_NEAR(swing(GeometricTerm::dropped, steps[1], implicit).length, 4.44, 0.1 * 4.44);
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
    const auto matrix = implicit_matrix(hair.force, hair.particles, hair.state, h, h);
    const MatrixXd A = table(*matrix, 93);
    const VectorXd rhs = right_hand_side(hair.force, hair.particles, hair.state, h, h);
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

// The modes of a hanging chain across itself, from tensions over lengths, and the masses.
struct Modes {
  VectorXd squares;  // omega^2, ascending
  MatrixXd shapes;   // a column each, by particle 1, 2, ...
};

Modes hanging_modes(const Strand& strand) {
  const int n = strand.segments();
  MatrixXd K = MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i) {
    const double k = kGravity * strand.mass.tail(n - i).sum() / strand.rest_length[i];
    K(i, i) += k;
    if (i == 0) continue;
    K(i - 1, i - 1) += k;
    K(i, i - 1) -= k;
    K(i - 1, i) -= k;
  }
  const VectorXd root = strand.mass.tail(n).cwiseSqrt().cwiseInverse();
  const solver::SymmetricEigen eigen = solver::symmetric_eigen(root.asDiagonal() * K * root.asDiagonal());
  return {eigen.values, root.asDiagonal() * eigen.vectors};
}

// Lets the hair hang still, displaced by `amplitude` of a mode. H4's springs carry the weight.
void hang(Hair& hair, const VectorXd& mode, double amplitude, bool stretched) {
  hair.place(-Vector3d::UnitZ());
  const Strand& strand = hair.strand;
  const int n = strand.segments();
  for (int i = 0; i < n; ++i) {
    const double weight = stretched ? kGravity * strand.mass.tail(n - i).sum() : 0;
    const double length = strand.rest_length[i] * (1 + weight / strand.stretch_rigidity);
    hair.state.x[3 * i + 5] = hair.state.x[3 * i + 2] - length;
    hair.state.x[3 * i + 3] = amplitude * mode[i];
  }
}

// The largest growth of a mode within `steps` steps.
template <typename Step>
double growth(double h, int mode, int steps, bool stretched, Step step) {
  const Strand strand = human_hair();
  const Modes modes = hanging_modes(strand);
  const VectorXd shape = modes.shapes.col(mode).normalized();
  Hair hair(strand, GeometricTerm::dropped);
  hang(hair, shape, 1e-9, stretched);
  const VectorXd weighed =
      strand.mass.tail(30).cwiseProduct(shape) / shape.cwiseAbs2().dot(strand.mass.tail(30));
  double largest = 0;
  for (int i = 0; i < steps && largest < 1e6; ++i) {
    step(hair, h);
    double amplitude = 0;
    for (int j = 0; j < 30; ++j) amplitude += weighed[j] * hair.state.x[3 * j + 3];
    largest = std::max(largest, std::abs(amplitude) / 1e-9);
  }
  return largest;
}

TEST(SwingingHair, MovesAcrossItselfLikeVelocityVerlet) {
  const Strand strand = human_hair();
  const Modes modes = hanging_modes(strand);
  for (bool corrected : {false, true})
    for (double h : {1.0 / 960, 1.0 / 240, 6e-3})
      for (int mode : {0, 3, 15, 29}) {
        const VectorXd shape = modes.shapes.col(mode).normalized();
        Hair hair(strand, GeometricTerm::dropped);
        // H4's springs feel the second order: a strain of angle^2 / 2.
        const double amplitude = corrected ? 1e-6 : 1e-8;
        hang(hair, shape, amplitude, !corrected);
        VectorXd x[3];
        for (int i = 0; i < 12; ++i) {
          x[0] = x[1];
          x[1] = x[2];
          x[2] = hair.state.x;
          if (corrected)
            hair.corrected_step(h);
          else
            hair.implicit_step(h);
          if (i < 3) continue;
          // omega_h = (2/h) asin(h omega/2), that is, x(n+1) + x(n-1) = (2 - h^2 omega^2) x(n).
          double worst = 0;
          for (int j = 1; j <= 30; ++j)
            worst = std::max(
                worst, std::abs(x[2][3 * j] + x[0][3 * j] - (2 - h * h * modes.squares[mode]) * x[1][3 * j]));
          // H4's hair is longer by its weight, and swings slower by 1e-6. In a step H6's filter feels forces
          // as far as sound travels: tension is off by l0 / (h c), with the speed of sound c, 1500 m/s.
          const double square = h * h * modes.squares[mode], share = corrected ? 0.01 / (1500 * h) : 0;
          EXPECT_LE(worst, (1e-5 + share * square) * amplitude)
              << (corrected ? "H6" : "H4") << ", h = " << h << ", mode " << mode;
        }
      }
}

TEST(SwingingHair, HasALimitOfTheTimeStep) {
  const double limit = 6.31e-3;
  const auto h4 = [](Hair& hair, double h) { hair.implicit_step(h); };
  const auto h6 = [](Hair& hair, double h) { hair.corrected_step(h); };
  EXPECT_LE(growth(0.98 * limit, 29, 1000, true, h4), 10);
  EXPECT_GE(growth(1.02 * limit, 29, 200, true, h4), 1e4);
  EXPECT_LE(growth(0.98 * limit, 29, 1000, false, h6), 10);
  EXPECT_GE(growth(1.02 * limit, 29, 200, false, h6), 1e4);
}

TEST(FlungRoot, StrainsHairByItsSpeedOverThatOfSound) {
  const int n = 300;
  const hair::Material material;
  const Strand strand = hair::uniform_strand(material, n, 0.3);
  Hair hair(strand, GeometricTerm::filtered, 0);
  hair.place(Vector3d::UnitX());
  hair.state.v[0] = -100;
  const double sound = std::sqrt(material.young_modulus / material.density);
  const double h = 0.05 * strand.rest_length[0] / sound;
  for (int i = 0; i < 3000; ++i) hair.implicit_step(h);
  // The wave is half-way. Behind it the strain is uniform, up to the front's ripples.
  double strain = 0;
  for (int i = 0; i < 75; ++i) strain += (segment(hair.state.x, i).norm() / strand.rest_length[i] - 1) / 75;
  EXPECT_NEAR(strain, 100 / sound, 0.002 * 100 / sound) << "6.6 %";
  EXPECT_NEAR(100 / sound, 0.066, 5e-4);
}

}  // namespace
}  // namespace reference_tests
