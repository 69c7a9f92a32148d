#include "hair/lab/validate/measure_mode.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hair/lab/validate/sinusoid.h"

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

}  // namespace

MeasuredMode measure_mode(const ChainMethod& method, const HangingChain& chain, double x, double highest,
                          const ValidationSettings& settings) {
  const Eigen::VectorXd angles = mode_angles(chain, x);
  const double c = softening(chain, x, angles), w = std::sqrt(x * chain.square_unit());
  MeasuredMode result;
  result.angle = std::min(kLargestAngle, std::sqrt(kSoftest / std::abs(c)));
  result.softening = 2 * c * result.angle * result.angle;
  result.step = std::min(kLongestTurn, kHighestTurn * std::sqrt(x / highest)) / w;
  const double in_a_period = 2 * std::numbers::pi / (w * result.step);
  const double periods = std::clamp(kMostSteps / in_a_period, kFewestPeriods, settings.quick ? 2.0 : 4.0);
  const int steps = static_cast<int>(periods * in_a_period);
  result.steps = steps;

  const particles::State start = turned(chain, result.angle * angles);
  const Eigen::VectorXd weights = weights_of(chain, angles);
  const std::unique_ptr<MovingChain> moving = method.start(chain, start, result.step);
  Eigen::VectorXd out(steps + 1);
  const double first = weights.dot(start.x);
  for (int k = 0;; ++k) {
    out[k] = weights.dot(moving->state().x) / first;
    if (k == steps) break;
    if (k % kStepsInARow == 0) settings.go_on();
    moving->step();
  }
  const Sinusoid fit = fit_sinusoid(out);
  const double measured = method.undo(fit.frequency / result.step, result.step);
  result.square = measured * measured / chain.square_unit() / (1 + result.softening);
  const double left = std::min(kWorstFit, fit.residual / fit.amplitude), turn = w * result.step;
  result.decay = fit.decay;
  if (!std::isfinite(fit.frequency)) result.decay = fit.frequency;
  result.expected_decay = method.decay(chain, x, turn);
  result.decay_tolerance =
      2 * (turn * turn * std::abs(result.softening) + method.decay_error(chain, x, turn) + 10 * left / steps);
  result.tolerance = 2 * (turn * turn * std::abs(result.softening) + 2 * method.other_error(chain, x) +
                          2 * 10 * left / (turn * steps));
  return result;
}

}  // namespace hair
