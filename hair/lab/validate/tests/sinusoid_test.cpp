#include "hair/lab/validate/sinusoid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>

#include "hair/lab/validate/dispersion.h"

namespace hair {
namespace {

Eigen::VectorXd sampled(double frequency, double decay, double phase, int count) {
  Eigen::VectorXd samples(count);
  for (int k = 0; k < count; ++k) samples[k] = std::exp(-decay * k) * std::cos(frequency * k + phase);
  return samples;
}

// Rounding of the samples: 2^-53 of the phase, up to 40 rad, in each, over a phase of as much.
TEST(Sinusoid, FrequencyAndDecayAreFoundToRounding) {
  for (const double frequency : {0.01, 0.1, 0.5})
    for (const double decay : {0.0, 1e-4, 1e-3})
      for (const double phase : {0.0, 1.0}) {
        const Sinusoid fit = fit_sinusoid(sampled(frequency, decay, phase, static_cast<int>(25 / frequency)));
        EXPECT_NEAR(fit.frequency / frequency, 1, 1e-14) << frequency << " " << decay << " " << phase;
        EXPECT_NEAR(fit.decay, decay, 1e-14) << frequency << " " << decay << " " << phase;
        EXPECT_NEAR(fit.amplitude, 1, 1e-13);
        EXPECT_LE(fit.residual, 1e-14);
      }
}

TEST(Sinusoid, WhatIsNoneHasNoFrequency) {
  Eigen::VectorXd samples = sampled(0.1, 0, 0, 200);
  EXPECT_TRUE(std::isnan(fit_sinusoid(Eigen::VectorXd::Ones(50)).frequency));
  EXPECT_TRUE(std::isnan(fit_sinusoid(Eigen::VectorXd::Zero(50)).frequency));
  EXPECT_TRUE(std::isnan(fit_sinusoid(samples.head(40)).frequency)) << "it changes its sign once";
  EXPECT_TRUE(std::isnan(fit_sinusoid({}).frequency));
  samples[20] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(fit_sinusoid(samples).frequency));
}

// Its frequency triples on the way: no single frequency fits.
TEST(Sinusoid, AFitThatDoesNotConvergeHasNoFrequency) {
  Eigen::VectorXd samples(50);
  for (int k = 0; k < 50; ++k) samples[k] = std::cos(0.2 * k + 0.004 * k * k);
  EXPECT_TRUE(std::isnan(fit_sinusoid(samples).frequency));
}

// The recurrence itself, with w h = y.
TEST(Dispersion, LeapfrogIsUndone) {
  for (const double y : {0.01, 0.2, 1.0, 1.9}) {
    Eigen::VectorXd x(400);
    x[0] = 1;
    x[1] = 1 - y * y / 2;
    for (int n = 1; n + 1 < x.size(); ++n) x[n + 1] = (2 - y * y) * x[n] - x[n - 1];
    if (y < 0.05) continue;  // less than three changes of sign
    EXPECT_NEAR(undo_leapfrog(fit_sinusoid(x).frequency, 1) / y, 1, 1e-12) << y;
  }
}

TEST(Dispersion, RungeKuttaIsUndone) {
  for (const double step : {1.0, 1e-3})
    for (const double y : {1e-3, 0.1, 0.5, 1.0, 1.5}) {
      const std::complex<double> z(0, y), factor = 1.0 + z * (1.0 + z * (0.5 + z * (1.0 / 6 + z / 24.0)));
      EXPECT_NEAR(undo_runge_kutta_4(std::arg(factor) / step, step) * step / y, 1, 1e-13) << y;
    }
}

// A step of h = 1 divides by 1 - iy.
TEST(Dispersion, ImplicitEulerIsUndone) {
  for (const double y : {0.01, 0.2, 1.0, 3.0}) {
    const double measured = std::arg(1.0 / std::complex<double>(1, -y));
    EXPECT_NEAR(undo_implicit_euler(measured, 1) / y, 1, 1e-14) << y;
    EXPECT_NEAR(std::abs(1.0 / std::complex<double>(1, -y)), std::cos(measured), 1e-15) << y;
  }
}

// The map of (x, h v) in dispersion.h: two filters, each dividing a kick and the old value by 1 + y^2/2.
TEST(Dispersion, FiltersAreUndone) {
  for (const double y : {0.05, 0.2, 1.0}) {
    const double c = y * y / 2 / (1 + y * y / 2);
    Eigen::VectorXd x(400);
    double place = 1, speed = 0;
    for (double& sample : x) {
      sample = place;
      const double before = (1 - c) * speed - c * place, after = place + before;
      speed = (1 - c) * before - c * after;
      place = after;
    }
    const Sinusoid fit = fit_sinusoid(x);
    EXPECT_NEAR(undo_filters(fit.frequency, 1) / y, 1, 1e-12) << y;
    EXPECT_NEAR(fit.decay, -std::log(std::cos(fit.frequency)), 1e-12) << y;
  }
}

}  // namespace
}  // namespace hair
