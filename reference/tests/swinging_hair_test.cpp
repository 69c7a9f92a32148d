// STAFF ONLY. Human hair, 30 cm in 30 segments, swinging under gravity: how much H4 and H6 stretch it, what the solver's
// tolerance does to it, and how fast it may swing across itself.

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <vector>

#include "reference/tests/stepping.h"

namespace reference_tests {
namespace {

using hair::GeometricTerm;
using hair::Strand;

Strand human_hair() {
  return hair::uniform_strand({}, 30, 0.3);
}

struct Swing {
  double length = 0;  // the largest |l - l0| / l0
  double rate = 0;    // the largest velocity along a segment, m/s
  double energy = 0;  // the largest gain of kinetic and potential energy over m g L
};

// From level, at rest, for a second.
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
      energy += strand.mass[j] * (0.5 * hair.state.v.segment<3>(3 * j).squaredNorm() +
                                  kGravity * hair.state.x[3 * j + 2]);
    result.energy = std::max(result.energy, energy / unit);
  }
  return result;
}

void implicit(Hair& hair, double h) {
  hair.implicit_step(h);
}

void corrected(Hair& hair, double h) {
  const hair::StepReport report = hair.corrected_step(h);
  EXPECT_TRUE(report.correction.converged);
  EXPECT_LE(report.correction.iterations, 6);
}

TEST(SwingingHair, PredictorCorrectorKeepsEverySegmentsLength) {
  for (double h : {1.0 / 60, 1.0 / 240, 1.0 / 960}) {
    const Swing result = swing(GeometricTerm::filtered, h, corrected);
    EXPECT_LE(result.length, 1e-10) << "h = " << h;
    EXPECT_LE(result.rate, 1e-4) << "h = " << h;
    RecordProperty("H6, h " + std::to_string(h), std::to_string(result.length));
    std::printf("H6 h %.5f: length %.1e rate %.1e energy %.3f\n", h, result.length, result.rate, result.energy);
  }
}

TEST(SwingingHair, LinearlyImplicitEulerStretchesIt) {
  for (GeometricTerm term : {GeometricTerm::full, GeometricTerm::filtered, GeometricTerm::dropped})
    for (double h : {1.0 / 60, 1.0 / 240, 1.0 / 960}) {
      const Swing result = swing(term, h, implicit);
      std::printf("H4 term %d h %.5f: length %.2e rate %.1e energy %.3f\n", static_cast<int>(term), h, result.length,
                  result.rate, result.energy);
    }
}

TEST(SwingingHair, OnePassOfRelaxationAloneAddsEnergy) {
  for (int passes : {1, 2, 5}) {
    const Swing result = swing(GeometricTerm::filtered, 1.0 / 240, [&](Hair& hair, double h) {
      VectorXd before = hair.state.x;
      hair.state.v.tail(90) -= h * kGravity * Vector3d(0, 0, 1).replicate(30, 1);
      hair.state.x += h * hair.state.v;
      relax_lengths(hair.strand, 1e-12, passes, hair.state.x);
      hair.state.v = (hair.state.x - before) / h;
    });
    std::printf("relax passes %d: length %.1e energy %.3f\n", passes, result.length, result.energy);
    const Swing r2 = swing(GeometricTerm::filtered, 1.0 / 240, [&](Hair& hair, double h) {
      hair.state.v.tail(90) -= h * kGravity * Vector3d(0, 0, 1).replicate(30, 1);
      hair.state.x += h * hair.state.v;
      relax_lengths(hair.strand, 1e-12, passes, hair.state.x);
    });
    std::printf("relax positions only passes %d: length %.1e energy %.3f\n", passes, r2.length, r2.energy);
    const Swing r3 = swing(GeometricTerm::filtered, 1.0 / 240, [&](Hair& hair, double h) {
      VectorXd dv(93); auto sc = hair.scratch.leftCols(6);
      solve_implicit(hair.force, hair.particles, hair.state, h / 2, h, 1e-10, dv, sc);
      hair.state.v += dv;
      hair.state.x += h * hair.state.v; VectorXd p = hair.state.x;
      relax_lengths(hair.strand, 1e-12, passes, hair.state.x); hair.state.v += (hair.state.x - p) / h;
      solve_implicit(hair.force, hair.particles, hair.state, h / 2, h, 1e-10, dv, sc); hair.state.v += dv;
    });
    std::printf("H6 with relax passes %d: length %.1e energy %.3f\n", passes, r3.length, r3.energy);
  }
}

}  // namespace
}  // namespace reference_tests
