#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "hair/lab/validate/dispersion.h"
#include "hair/lab/validate/measure_mode.h"
#include "hair/lab/validate/validations.h"

namespace hair {

namespace {

constexpr double kLongestTurn = 0.2;     // rad that the mode turns in a step
constexpr double kHighestTurn = 0.5;     // rad for the fastest mode, which must stay stable
constexpr double kMostSteps = 20000;     // beyond, fewer periods are enough,
constexpr double kFewestPeriods = 1.75;  // as long as it changes its sign three times
constexpr int kStepsInARow = 1000;       // between looks at Ctrl-C

// The amplitudes of all masses in the mode: a product with its shape that removes other modes, because shapes
// are orthogonal with masses as weights.
Eigen::VectorXd weights_of(const HangingChain& chain, const Eigen::VectorXd& angles) {
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(3 * chain.count() + 3);
  double sideways = 0;
  for (int i = 0; i < chain.count(); ++i) {
    sideways += angles[i];
    weights[3 * i + 3] = chain.mass[i] * sideways;
  }
  return weights;
}

constexpr double kMass = 1e-7;  // kg: about a centimetre of hair
constexpr double kLink = 0.01;  // m

Check check_of(const MeasuredMode& mode, double x) {
  Check check;
  check.expected = x;
  check.measured = mode.square;
  check.tolerance = mode.tolerance * x;
  check.tolerance_from = kModeTolerance;
  return check;
}

// The largest error over its tolerance; NaN if one of them is NaN.
class Worst {
 public:
  void add(double error, double tolerance) {
    const double one = std::abs(error) / tolerance;
    if (!std::isnan(value_) && !(one <= value_)) value_ = one;
  }
  double value() const { return value_; }

 private:
  double value_ = 0;
};

Check check_of_decays(const Worst& worst, const std::string& id, const std::string& shows) {
  return {id,
          shows + ": the worst error of what a step takes from the amplitude",
          "0 to n s x / 2 of H6, -log |R(iwh)| of Runge-Kutta 4 (dispersion.h)",
          0,
          worst.value(),
          1,
          "in units of each mode's own tolerance (measure_mode.h)"};
}

// Among the modes in between only the worst is a check, so that the list stays short.
bool has_check(int mode, int n) {
  return mode <= 3 || mode == n;
}

ValidationResult swing_chains(const ChainMethod& method, const ValidationSettings& settings) {
  ValidationResult result;
  for (const int n : {2, 10, 20}) {
    const HangingChain chain{Eigen::VectorXd::Constant(n, kMass), kLink};
    const Eigen::VectorXd zeros = laguerre_zeros(n);
    const std::string masses = std::to_string(n) + " masses";
    Worst others, decays;
    for (int mode = 1; mode <= n; ++mode) {
      if (settings.quick && !has_check(mode, n)) continue;
      const double x = zeros[mode - 1];
      const MeasuredMode measured = measure_mode(method, chain, x, zeros[n - 1], settings);
      const std::string number = std::to_string(mode);
      decays.add(measured.decay - measured.expected_decay, measured.decay_tolerance);
      if (!has_check(mode, n)) {
        others.add(measured.square / x - 1, measured.tolerance);
        continue;
      }
      Check& check = result.checks.emplace_back(check_of(measured, x));
      check.id = "n" + std::to_string(n) + "-mode" + number;
      check.shows = masses + ", mode " + number + ": l w^2 / g";
      check.source = "zero " + number + " of the Laguerre polynomial L_" + std::to_string(n) +
                     " (Abramowitz and Stegun, 22.7.12 and table 25.9)";
    }
    if (others.value() != 0)
      result.checks.push_back({"n" + std::to_string(n) + "-other-modes",
                               masses + ", all other modes: the worst error",
                               "the other zeros of L_" + std::to_string(n), 0, others.value(), 1,
                               "in units of each mode's own tolerance"});
    result.checks.push_back(
        check_of_decays(decays, "n" + std::to_string(n) + "-decay", masses + ", all modes"));
  }
  return result;
}

}  // namespace

MeasuredMode measure_mode(const ChainMethod& method, const HangingChain& chain, double x, double highest,
                          const ValidationSettings& settings) {
  const Eigen::VectorXd angles = mode_angles(chain, x);
  const double c = softening(chain, x, angles), w = std::sqrt(x * chain.square_unit());
  MeasuredMode result;
  const double angle = std::min(kLargestAngle, std::sqrt(kSoftest / std::abs(c)));
  const double softened = 2 * c * angle * angle;
  const double h = std::min(kLongestTurn, kHighestTurn * std::sqrt(x / highest)) / w;
  const double in_a_period = 2 * std::numbers::pi / (w * h);
  const double periods = std::clamp(kMostSteps / in_a_period, kFewestPeriods, settings.quick ? 2.0 : 4.0);
  const int steps = static_cast<int>(periods * in_a_period);

  const particles::State start = turned(chain, angle * angles);
  const Eigen::VectorXd weights = weights_of(chain, angles);
  const std::unique_ptr<MovingChain> moving = method.start(chain, start, h);
  Eigen::VectorXd out(steps + 1);
  const double first = weights.dot(start.x);
  for (int k = 0;; ++k) {
    out[k] = weights.dot(moving->state().x) / first;
    if (k == steps) break;
    if (k % kStepsInARow == 0) settings.go_on();
    moving->step();
  }
  const Sinusoid fit = fit_sinusoid(out);
  const double measured = method.undo(fit.frequency / h, h);
  result.square = measured * measured / chain.square_unit() / (1 + softened);
  const double left = std::min(kWorstFit, fit.residual / fit.amplitude), turn = w * h;
  result.decay = fit.decay;
  if (!std::isfinite(fit.frequency)) result.decay = fit.frequency;
  result.expected_decay = method.decay(chain, x, turn);
  result.decay_tolerance =
      2 * (turn * turn * std::abs(softened) + method.decay_error(chain, x, turn) + 10 * left / steps);
  result.tolerance = 2 * (turn * turn * std::abs(softened) + 2 * method.other_error(chain, x) +
                          2 * 10 * left / (turn * steps));
  return result;
}

Validation chain_oscillations(const ChainMethod& method) {
  return {"chain-" + method.id, "Small oscillations of N equal masses that hang, " + method.name,
          method.exercises,
          [&method](const ValidationSettings& settings) { return swing_chains(method, settings); }};
}

}  // namespace hair
