#include "hair/lab/validate/pendulum.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace hair {

namespace {

constexpr double kLongest = 5;  // times T0: longer than any quarter of a period here

struct Swing {
  double angle, rate;  // rad, rad/s; from hanging
};

Swing swing_of(const HangingChain& chain, const particles::State& state) {
  const double angle = std::atan2(state.x[3], -state.x[5]);
  return {angle, (state.v[3] * std::cos(angle) + state.v[5] * std::sin(angle)) / chain.link};
}

// The part of a step of h from `before` until it hangs straight: a zero of the cubic with both angles and
// rates. There the angle's second and fourth derivatives are 0, so this is better than most methods.
double part_until_straight(const Swing& before, const Swing& after, double h) {
  const auto angle = [&](double t) {
    const double u = 1 - t;
    return u * u * ((1 + 2 * t) * before.angle + t * h * before.rate) +
           t * t * ((1 + 2 * u) * after.angle - u * h * after.rate);
  };
  double low = 0, high = 1;
  while (high - low > std::numeric_limits<double>::epsilon()) {
    const double middle = (low + high) / 2;
    (angle(middle) > 0 ? low : high) = middle;
  }
  return low;
}

}  // namespace

double period_ratio(double angle) {
  double a = 1, g = std::cos(angle / 2);
  while (std::abs(a - g) > 1e-15) {
    const double mean = (a + g) / 2;
    g = std::sqrt(a * g);
    a = mean;
  }
  return 1 / a;
}

double measured_period_ratio(const ChainMethod& method, double angle, int steps_per_small_period,
                             const ValidationSettings& settings) {
  HangingChain chain{Eigen::VectorXd::Constant(1, 1e-7)};
  // Each step stretches by this much, and the correction's damping adds up over more, smaller steps.
  chain.stretch = 1e-11;
  const double small_period = 2 * std::numbers::pi / std::sqrt(chain.square_unit());
  const double h = small_period / steps_per_small_period;
  const particles::State start = turned(chain, Eigen::VectorXd::Constant(1, angle));
  const std::unique_ptr<MovingChain> moving = method.start(chain, start, h);
  Swing before = swing_of(chain, start);
  for (int k = 0; k < kLongest * steps_per_small_period; ++k) {
    if (k % 1000 == 0) settings.go_on();
    moving->step();
    const Swing after = swing_of(chain, moving->state());
    if (!std::isfinite(after.angle) || !std::isfinite(after.rate)) break;
    if (after.angle <= 0) return 4 * (k + part_until_straight(before, after, h)) / steps_per_small_period;
    before = after;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace hair
