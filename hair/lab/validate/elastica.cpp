#include "hair/lab/validate/elastica.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "particles/require.h"

namespace hair {

namespace {

// psi, its derivative, and the tip's distances from here: level and down, over L.
using Values = Eigen::Vector4d;

struct Rod {
  double gamma, stretch;
  double square = 0;  // square of a segment's length, over L

  Values derivative(double t, const Values& y) const {
    const double sine = std::sin(y[0]), cosine = std::cos(y[0]);
    const double longer = 1 + stretch * t * cosine;
    const double bend = gamma * t * longer * sine;
    const double bend_twice =
        square == 0 ? 0 : gamma * (2 * cosine * y[1] + t * (cosine * gamma * t * sine - sine * y[1] * y[1]));
    return {y[1], bend - square / 12 * bend_twice, longer * sine, longer * cosine};
  }

  double slope_at_tip(double psi) const { return -square / 24 * gamma * std::sin(psi); }
  double psi_at_root() const { return std::numbers::pi / 2 - square / 8 * gamma; }

  // From the tip to here, by the midpoint rule: its difference from the integral is a derivative at either
  // end.
  Eigen::Vector2d place(const Values& y) const {
    return y.tail<2>() - square / 24 * y[1] * Eigen::Vector2d(std::cos(y[0]), -std::sin(y[0]));
  }
};

// The curve from the tip to the clamp, kElasticaParts + 1 columns, by the classical method of Runge and
// Kutta.
Eigen::Matrix4Xd shoot(const Rod& rod, double psi_at_tip, int steps_per_part) {
  Eigen::Matrix4Xd columns(4, kElasticaParts + 1);
  Values y(psi_at_tip, rod.slope_at_tip(psi_at_tip), 0, 0);
  const double h = 1.0 / (kElasticaParts * steps_per_part);
  for (int part = 0; part <= kElasticaParts; ++part) {
    columns.col(part) = y;
    if (part == kElasticaParts) break;
    for (int step = 0; step < steps_per_part; ++step) {
      const double t = (part * steps_per_part + step) * h;
      const Values k1 = rod.derivative(t, y), k2 = rod.derivative(t + h / 2, y + h / 2 * k1);
      const Values k3 = rod.derivative(t + h / 2, y + h / 2 * k2), k4 = rod.derivative(t + h, y + h * k3);
      y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
  }
  return columns;
}

// The logarithm of psi at the clamp grows with that of psi at the tip, the more slowly the larger psi is,
// because sin(psi) / psi falls. And psi grows by at most exp(2/3 sqrt(Gamma)), because psi' / psi stays below
// sqrt(Gamma t). So the first guess is too small, and so is every secant's.
//
// The remaining error is the last shot's distance from psi = psi_at_root. Errors grow along the way, so no
// angle is off by more, and no point is off by more than that times its distance.
Elastica solve(const Rod& rod, int steps_per_part) {
  const double target = std::log(rod.psi_at_root());
  double guess = target - 2.0 / 3 * std::sqrt(rod.gamma * (1 + rod.stretch)), slope = 1;
  double last_guess = 0, last_value = 0;
  Eigen::Matrix4Xd columns;
  for (int shot = 0; shot < 60; ++shot) {
    columns = shoot(rod, std::exp(guess), steps_per_part);
    const double value = std::log(columns(0, kElasticaParts));
    if (shot > 0 && guess != last_guess && value != last_value)
      slope = (value - last_value) / (guess - last_guess);
    last_guess = guess;
    last_value = value;
    guess += (target - value) / slope;
    if (std::abs(target - value) <= 1e-13 * std::max(1.0, std::abs(guess))) break;
  }
  Elastica result{Eigen::Matrix2Xd(2, kElasticaParts + 1)};
  const Eigen::Vector2d root = rod.place(columns.col(kElasticaParts));
  for (int part = 0; part <= kElasticaParts; ++part)
    result.points.col(kElasticaParts - part) = root - rod.place(columns.col(part));
  result.error = std::abs(columns(0, kElasticaParts) - rod.psi_at_root()) * (1 + rod.stretch);
  return result;
}

}  // namespace

Elastica elastica(double gamma, double stretch, double segments) {
  particles::require(gamma > 0 && gamma <= 1e6, "an elastica's Gamma", gamma, "above 0, and at most 1e6");
  particles::require(stretch >= 0 && stretch <= 1, "an elastica's stretch", stretch, "0 to 1");
  particles::require(segments >= std::sqrt(gamma), "the segments of an elastica", segments,
                     "sqrt(Gamma) or more");
  const Rod rod{gamma, stretch, 1 / (segments * segments)};
  // At least a hundred steps while psi grows by a factor e.
  const int steps = 10 + static_cast<int>(std::sqrt(gamma) * 100 / kElasticaParts);
  Elastica result = solve(rod, 2 * steps);
  result.error += (result.points - solve(rod, steps).points).colwise().norm().maxCoeff() / 15;
  return result;
}

bool has_an_order(double gamma, int segments) {
  return segments >= 1.3 * std::sqrt(gamma);
}

double next_term(double gamma, int segments) {
  return 9.0 / 80 * gamma / (segments * segments);
}

StrandElastica strand_elastica(double gamma, double stretch, int segments) {
  const Eigen::Vector2d tip = elastica(gamma, stretch, segments).tip();
  const double error = (tip - elastica(gamma, stretch).tip()).norm();
  return {tip, error, error * (next_term(gamma, segments) + stretch) + 1e-12};
}

}  // namespace hair
