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

// From the tip to the clamp, by the classical method of Runge and Kutta.
Values shoot(const Rod& rod, Values y, int steps) {
  const double h = 1.0 / steps;
  for (int step = 0; step < steps; ++step) {
    const double t = step * h;
    const Values k1 = rod.derivative(t, y), k2 = rod.derivative(t + h / 2, y + h / 2 * k1);
    const Values k3 = rod.derivative(t + h / 2, y + h / 2 * k2), k4 = rod.derivative(t + h, y + h * k3);
    y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return y;
}

// The logarithm of psi at the clamp grows with that of psi at the tip, the more slowly the larger psi is,
// because sin(psi) / psi falls. And psi grows by at most exp(2/3 sqrt(Gamma)), because psi' / psi stays below
// sqrt(Gamma t). So the first guess is too small, and so is every secant's.
//
// The remaining error is the last shot's distance from psi = psi_at_root. Errors grow along the way, so no
// angle is off by more, and no point is off by more than that times its distance.
Elastica solve(const Rod& rod, int steps) {
  const double target = std::log(rod.psi_at_root());
  double guess = target - 2.0 / 3 * std::sqrt(rod.gamma * (1 + rod.stretch)), slope = 1;
  double last_guess = 0, last_value = 0;
  Values tip = Values::Zero(), root = tip;
  for (int shot = 0; shot < 60; ++shot) {
    const double psi = std::exp(guess);
    tip = Values(psi, rod.slope_at_tip(psi), 0, 0);
    root = shoot(rod, tip, steps);
    const double value = std::log(root[0]);
    if (shot > 0 && guess != last_guess && value != last_value)
      slope = (value - last_value) / (guess - last_guess);
    last_guess = guess;
    last_value = value;
    guess += (target - value) / slope;
    if (std::abs(target - value) <= 1e-13 * std::max(1.0, std::abs(guess))) break;
  }
  return {rod.place(root) - rod.place(tip), std::abs(root[0] - rod.psi_at_root()) * (1 + rod.stretch)};
}

}  // namespace

Elastica elastica(double gamma, double stretch, double segments) {
  particles::require(gamma > 0 && gamma <= 1e6, "an elastica's Gamma", gamma, "above 0, and at most 1e6");
  particles::require(stretch >= 0 && stretch <= 1, "an elastica's stretch", stretch, "0 to 1");
  particles::require(segments >= std::sqrt(gamma), "the segments of an elastica", segments,
                     "sqrt(Gamma) or more");
  const Rod rod{gamma, stretch, 1 / (segments * segments)};
  // At least a hundred steps while psi grows by a factor e.
  const int steps = 80 * (10 + static_cast<int>(std::sqrt(gamma) * 100 / 80));
  Elastica result = solve(rod, 2 * steps);
  result.error += (result.tip - solve(rod, steps).tip).norm() / 15;
  return result;
}

}  // namespace hair
