#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "hair/lab/validate/dispersion.h"
#include "hair/lab/validate/validations.h"

namespace hair {

namespace {

constexpr double kLongestTurn = 0.2;     // rad that the mode turns in a step
constexpr double kHighestTurn = 0.5;     // rad for the fastest mode, which must stay stable
constexpr double kMostSteps = 20000;     // beyond, fewer periods are enough,
constexpr double kFewestPeriods = 1.75;  // as long as it changes its sign three times
constexpr int kStepsInARow = 1000;       // between looks at Ctrl-C

constexpr double kSoftest = 1e-6, kLargestAngle = 1e-3, kWorstFit = 1e-6;  // see measure_mode

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

// Raises `worst` to an error over its tolerance. It stays NaN once it is.
void raise(double& worst, double error, double tolerance) {
  const double one = std::abs(error) / tolerance;
  if (!std::isnan(worst) && !(one <= worst)) worst = one;
}

// Among the modes in between only the worst is a check, so that the list stays short.
bool has_check(int mode, int n) {
  return mode <= 3 || mode == n;
}

ValidationResult swing_chains(const ChainMethod& method, const ValidationSettings& settings) {
  ValidationResult result;
  for (const int n : {2, 10, 20}) {
    const HangingChain chain{Eigen::VectorXd::Constant(n, kMass)};
    const Eigen::VectorXd zeros = laguerre_zeros(n);
    const std::string masses = std::to_string(n) + " masses";
    double others = 0, decays = 0;
    for (int mode = 1; mode <= n; ++mode) {
      if (settings.quick && !has_check(mode, n)) continue;
      const double x = zeros[mode - 1];
      const MeasuredMode measured = measure_mode(method, chain, x, zeros[n - 1], settings);
      const std::string number = std::to_string(mode);
      raise(decays, measured.decay - measured.expected_decay, measured.decay_tolerance);
      if (!has_check(mode, n)) {
        raise(others, measured.square / x - 1, measured.tolerance);
        continue;
      }
      result.checks.push_back({"n" + std::to_string(n) + "-mode" + number,
                               masses + ", mode " + number + ": l w^2 / g",
                               "zero " + number + " of the Laguerre polynomial L_" + std::to_string(n) +
                                   " (Abramowitz and Stegun, 22.7.12 and table 25.9)",
                               x, measured.square, measured.tolerance * x,
                               "twice the sum of: what a step makes of the swing's size; stretch or solves; "
                               "what the fit resolves"});
    }
    if (others != 0)
      result.checks.push_back({"n" + std::to_string(n) + "-other-modes",
                               masses + ", all other modes: the worst error",
                               "the other zeros of L_" + std::to_string(n), 0, others, 1,
                               "in units of each mode's own tolerance"});
    result.checks.push_back({"n" + std::to_string(n) + "-decay",
                             masses + ", all modes: the worst error of what a step takes from the amplitude",
                             "0 to n s x / 2 of H6, -log |R(iwh)| of Runge-Kutta 4 (dispersion.h)", 0, decays,
                             1, "in units of each mode's own tolerance (chain_methods.h)"});
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
  SceneRun run(method.scene(chain, start, h));
  Eigen::VectorXd out(steps + 1);
  const double first = weights.dot(start.x);
  for (int k = 0;; ++k) {
    out[k] = weights.dot(run.state().x) / first;
    if (k == steps) break;
    if (k % kStepsInARow == 0) settings.go_on();
    if (!run.advance()) continue;
    out.setConstant(std::numeric_limits<double>::quiet_NaN());  // the run broke
    break;
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
  result.tolerance = 2 * (turn * turn * std::abs(softened) + 2 * method.other_error(chain, x, turn) +
                          2 * 10 * left / (turn * steps));
  return result;
}

Validation chain_oscillations(const ChainMethod& method) {
  return {"chain-" + method.id, "Small oscillations of N equal masses that hang, " + method.name,
          method.exercises,
          [&method](const ValidationSettings& settings) { return swing_chains(method, settings); }};
}

}  // namespace hair
