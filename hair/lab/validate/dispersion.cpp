#include "hair/lab/validate/dispersion.h"

#include <Eigen/QR>
#include <cmath>
#include <limits>
#include <numbers>

namespace hair {

namespace {

// From the first and the last zero, and the number of zeros in between; NaN for fewer than three.
double frequency_of_signs(const Eigen::VectorXd& samples) {
  double first = 0, last = 0;
  int count = 0;
  for (Eigen::Index k = 0; k + 1 < samples.size(); ++k) {
    if (!((samples[k] < 0) != (samples[k + 1] < 0))) continue;
    last = static_cast<double>(k) + samples[k] / (samples[k] - samples[k + 1]);
    if (count++ == 0) first = last;
  }
  return count < 3 ? std::numeric_limits<double>::quiet_NaN()
                   : std::numbers::pi * (count - 1) / (last - first);
}

constexpr int kMostGaussNewtonSteps = 30;
constexpr double kClose = 1e-14, kCloseEnough = 1e-10;  // ends the iteration; a result after all steps

}  // namespace

Sinusoid fit_sinusoid(const Eigen::VectorXd& samples) {
  Sinusoid fit;
  fit.frequency = frequency_of_signs(samples);
  if (!samples.allFinite() || !std::isfinite(fit.frequency)) {
    fit.frequency = std::numeric_limits<double>::quiet_NaN();
    return fit;
  }
  const Eigen::Index n = samples.size();
  double a = samples[0], b = 0;
  Eigen::MatrixXd derivatives(n, 4);  // by a, b, frequency, decay
  Eigen::VectorXd left(n);
  double change_left = 1;  // relative
  for (int step = 0;; ++step) {
    for (Eigen::Index k = 0; k < n; ++k) {
      const double t = static_cast<double>(k), fading = std::exp(-fit.decay * t);
      const double c = fading * std::cos(fit.frequency * t), s = fading * std::sin(fit.frequency * t);
      left[k] = samples[k] - (a * c + b * s);
      derivatives.row(k) << c, s, t * (b * c - a * s), -t * (a * c + b * s);
    }
    if (change_left <= kClose || step == kMostGaussNewtonSteps) break;
    const Eigen::Vector4d change = derivatives.householderQr().solve(left);
    a += change[0];
    b += change[1];
    fit.frequency += change[2];
    fit.decay += change[3];
    change_left = change.head<2>().norm() / std::hypot(a, b) +
                  (std::abs(change[2]) + std::abs(change[3])) / std::abs(fit.frequency);
  }
  if (!(change_left <= kCloseEnough)) fit.frequency = std::numeric_limits<double>::quiet_NaN();
  fit.amplitude = std::hypot(a, b);
  fit.residual = std::sqrt(left.squaredNorm() / static_cast<double>(n));
  return fit;
}

double undo_leapfrog(double measured, double step) {
  return 2 / step * std::sin(measured * step / 2);
}

double undo_runge_kutta_4(double measured, double step) {
  double y = measured * step;
  for (int i = 0; i < 20; ++i) {
    const double sine = y - y * y * y / 6, cosine = 1 - y * y / 2 + y * y * y * y / 24;
    // d sine = 1 - y^2/2, d cosine = -sine
    const double slope = ((1 - y * y / 2) * cosine + sine * sine) / (sine * sine + cosine * cosine);
    y -= (std::atan2(sine, cosine) - measured * step) / slope;
  }
  return y / step;
}

double runge_kutta_4_decay(double y) {
  const double square = y * y;
  return -std::log1p(square * square * square * (square / 576 - 1.0 / 72)) / 2;
}

double undo_implicit_euler(double measured, double step) {
  return std::tan(measured * step) / step;
}

double undo_filters(double measured, double step) {
  const double sine = std::sin(measured * step / 2);  // 1 / cos - 1 = 2 sine^2 / cos, without a difference
  return 2 * sine / std::sqrt(std::cos(measured * step)) / step;
}

}  // namespace hair
