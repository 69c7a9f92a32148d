#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "hair/lab/validate/validations.h"

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

// Two runs remove the first term of the error's series a h^p + b h^(p+1) + ... (L. F. Richardson): `coarse`
// with steps of h and `fine` with h/2.
double extrapolated(double coarse, double fine, int order) {
  return fine + (fine - coarse) / (std::exp2(order) - 1);
}

// T/T0 as period_ratio, measured with one mass on one link, with `steps_per_small_period` steps for T0: four
// times the time from the release to the lowest point, so that a method's later losses don't matter. NaN if
// the mass never gets there.
double measured_period_ratio(const ChainMethod& method, double angle, int steps_per_small_period,
                             const ValidationSettings& settings) {
  HangingChain chain{Eigen::VectorXd::Constant(1, 1e-7)};
  // Each step stretches by this much, and the correction's damping adds up over more, smaller steps.
  chain.stretch = 1e-11;
  const double small_period = 2 * std::numbers::pi / std::sqrt(chain.square_unit());
  const double h = small_period / steps_per_small_period;
  const particles::State start = turned(chain, Eigen::VectorXd::Constant(1, angle));
  SceneRun run(method.scene(chain, start, h));
  Swing before = swing_of(chain, start);
  for (int k = 0; k < kLongest * steps_per_small_period; ++k) {
    if (k % 1000 == 0) settings.go_on();
    if (run.advance()) break;
    const Swing after = swing_of(chain, run.state());
    if (after.angle <= 0) return 4 * (k + part_until_straight(before, after, h)) / steps_per_small_period;
    before = after;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

struct Periods {
  std::array<int, 3> steps;        // for a small swing's period
  std::array<double, 3> measured;  // T/T0
};

Periods measure_periods(const ChainMethod& method, double angle, const ValidationSettings& settings) {
  const int coarsest = method.order == 1 ? 800 : 200;
  Periods periods{{coarsest, 2 * coarsest, 4 * coarsest}, {}};
  for (std::size_t i = 0; i < 3; ++i)
    periods.measured[i] = measured_period_ratio(method, angle, periods.steps[i], settings);
  return periods;
}

Check check_of(const Periods& periods, double degrees, double expected, int order) {
  const auto& [coarse, middle, fine] = periods.measured;
  const double measured = extrapolated(middle, fine, order);
  const double change = std::abs(measured - extrapolated(coarse, middle, order));
  // Steps of w0 h = 2 pi/steps; a method that has lost an order changes more than that.
  const double next_term = std::pow(2 * std::numbers::pi / periods.steps[2], order + 1);
  return {"period-" + to_text(degrees),
          "out to " + to_text(degrees) + " degrees: T/T0, of four quarters, extrapolated to h = 0",
          "1/agm(1, cos(angle/2)): Landau and Lifshitz, Mechanics, section 11; Abramowitz and Stegun, 17.6",
          expected,
          measured,
          change < next_term ? change : next_term,
          "by how much halving the steps changed the extrapolated value: 3 times its error or more; but not "
          "more than (2 pi/steps)^(order + 1), the order's next term"};
}

// The order from three step sizes. For a h^p + b h^(p+1) it is p + log2((1 + r) / (1 + r/2)), about p + r / 2
// log(2), with r the part of b in the first difference; halving the steps changes the extrapolated value by r
// / 2 (2^p - 1) of that difference.
Check check_of_order(const Periods& periods, double degrees, int order) {
  const auto& [coarse, middle, fine] = periods.measured;
  const double change = std::abs(extrapolated(middle, fine, order) - extrapolated(coarse, middle, order));
  const double shift = (std::exp2(order) - 1) * change / std::abs(coarse - middle) / std::numbers::ln2;
  return {
      "order",
      "out to " + to_text(degrees) + " degrees: order of the error",
      order == 1 ? "H6 loses (h/2) times the cube of the angle's rate: the README's \"Truth from outside\""
                 : "E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, II.1",
      static_cast<double>(order),
      std::log2((coarse - middle) / (middle - fine)),
      std::min(0.5, 2 * shift),
      "twice what the series' next term, measured by how much the extrapolated value changed, makes of it; "
      "but not more than a half, where another order is as near"};
}

ValidationResult swing(const ChainMethod& method, const ValidationSettings& settings) {
  ValidationResult result;
  Table table{method.name, {"degrees", "steps for T0", "T/T0", "error"}, {}};
  for (const double degrees : {30.0, 60.0, 90.0, 150.0, 170.0}) {
    const double angle = degrees * std::numbers::pi / 180, expected = period_ratio(angle);
    const Periods periods = measure_periods(method, angle, settings);
    result.checks.push_back(check_of(periods, degrees, expected, method.order));
    if (degrees == 90) result.checks.push_back(check_of_order(periods, degrees, method.order));
    for (std::size_t i = 0; i < 3; ++i)
      table.rows.push_back({to_text(degrees), std::to_string(periods.steps[i]),
                            printed("%.9g", periods.measured[i]), to_text(periods.measured[i] - expected)});
  }
  result.tables.push_back(std::move(table));
  return result;
}

}  // namespace

Validation pendulum_period(const ChainMethod& method) {
  return {"pendulum-" + method.id, "The period of a pendulum's large swings, " + method.name,
          method.exercises,
          [&method](const ValidationSettings& settings) { return swing(method, settings); }};
}

}  // namespace hair
