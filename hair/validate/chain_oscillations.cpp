#include <cmath>
#include <string>

#include "hair/validate/measure_mode.h"
#include "hair/validate/validations.h"

namespace hair {

namespace {

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

std::vector<std::string> row_of(const std::string& what, const MeasuredMode& mode, double x) {
  return {what,
          to_text(mode.step * std::sqrt(x * 9.81 / kLink)),
          to_text(mode.angle),
          to_text(mode.steps),
          to_text(mode.square / x - 1),
          to_text(mode.softening),
          to_text(mode.tolerance)};
}

Table table_of_modes(const std::string& caption, const std::string& first) {
  return {caption, {first, "w h", "angle", "steps", "error of w^2", "of it by the angle", "tolerance"}, {}};
}

ValidationResult swing_chains(const ChainMethod& method, const ValidationSettings& settings) {
  ValidationResult result;
  Figure figure;
  figure.id = "chain-" + method.id;
  figure.title = "Modes of hanging chains: relative error of w^2";
  figure.description =
      "For each mode of chains of 2, 10 and 20 masses the error of w^2, and what the theory of larger "
      "swings says that it is.";
  figure.x = {"mode", false};
  figure.y = {"relative error of w^2"};
  for (const int n : {2, 10, 20}) {
    const HangingChain chain{Eigen::VectorXd::Constant(n, kMass), kLink};
    const Eigen::VectorXd zeros = laguerre_zeros(n);
    const std::string masses = std::to_string(n) + " masses";
    Series errors{masses, {}}, theory{masses + ", theory of the angle", {}, true, false, true};
    Table table = table_of_modes(masses + ", " + method.name, "mode");
    for (int k = 0; k < n; ++k) {
      if (settings.quick && k > 0 && k < n - 1) continue;
      const MeasuredMode mode = measure_mode(method, chain, zeros[k], zeros[n - 1], settings);
      const std::string number = std::to_string(k + 1);
      const double error = std::abs(mode.square / zeros[k] - 1);
      if (error > 0) errors.points.push_back({k + 1.0, error});
      theory.points.push_back({k + 1.0, std::abs(mode.softening)});
      table.rows.push_back(row_of(number, mode, zeros[k]));
      Check& check = result.checks.emplace_back(check_of(mode, zeros[k]));
      check.id = "n" + std::to_string(n) + "-mode" + number;
      check.shows = masses + ", mode " + number + ": l w^2 / g";
      check.source = "zero " + number + " of the Laguerre polynomial L_" + std::to_string(n) +
                     " (Abramowitz and Stegun, table 25.9; DLMF 3.5(v))";
    }
    figure.series.push_back(std::move(errors));
    figure.series.push_back(std::move(theory));
    result.tables.push_back(std::move(table));
  }
  result.figures.push_back(std::move(figure));
  return result;
}

ValidationResult swing_double_pendulums(const ChainMethod& method, const ValidationSettings& settings) {
  ValidationResult result;
  Table table = table_of_modes("Double pendulums, " + method.name, "mass ratio, mode");
  for (const double ratio : {1e-2, 1.0, 1e2, 1e4, 1e6}) {
    if (settings.quick && ratio != 1 && ratio != 1e6) continue;
    const HangingChain chain{Eigen::Vector2d(kMass, ratio * kMass), kLink};
    const Eigen::Vector2d squares = double_pendulum_squares(ratio);
    for (const int k : {0, 1}) {
      const MeasuredMode mode = measure_mode(method, chain, squares[k], squares[1], settings);
      const std::string name = k == 0 ? "slow" : "fast";
      table.rows.push_back(row_of(to_text(ratio) + ", " + name, mode, squares[k]));
      Check& check = result.checks.emplace_back(check_of(mode, squares[k]));
      check.id = "ratio" + to_text(ratio) + "-" + name;
      check.shows = "lower mass " + to_text(ratio) + " times the upper, " + name + ": l w^2 / g";
      check.source =
          "1 + mu -+ sqrt(mu (1 + mu)): L. D. Landau and E. M. Lifshitz, Mechanics, section 23, problem 2";
    }
  }
  result.tables.push_back(std::move(table));
  return result;
}

}  // namespace

Validation chain_oscillations(const ChainMethod& method) {
  return {"chain-" + method.id, "Small oscillations of N equal masses that hang, " + method.name,
          method.exercises,
          [&method](const ValidationSettings& settings) { return swing_chains(method, settings); }};
}

Validation double_pendulums(const ChainMethod& method) {
  return {"double-pendulum-" + method.id, "Two masses of very different weight, " + method.name,
          method.exercises,
          [&method](const ValidationSettings& settings) { return swing_double_pendulums(method, settings); }};
}

}  // namespace hair
