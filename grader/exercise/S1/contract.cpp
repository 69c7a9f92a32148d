// STAFF ONLY. S1: ConjGrad's hidden cases on what its arguments and its return value mean.
#include <algorithm>
#include <cmath>
#include <limits>

#include "grader/exercise/S1/cases.h"
#include "grader/suite/linear_system.h"

namespace grader::s1 {

using solver::log_spaced;

void first_guess(Trial& trial) {
  Random& random = trial.random;
  const int n = random.integer(10, 20);
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  const LinearSystem system = spectral_system("any first x", log_spaced(n, 1, 30), random);
  const double epsilon = tolerance_after(system, 4).epsilon;
  const Solution from_zero = solve(trial, system, epsilon, 0, std::vector<double>(n, 0.0));
  expect_solved(trial, system, from_zero, epsilon);
  for (const std::vector<double>& junk : {random.normals(n, 1e200), std::vector<double>(n, nan),
                                          std::vector<double>(n, infinity), system.solution}) {
    const Solution solution = solve(trial, system, epsilon, 0, junk);
    trial.expect(
        solution.x == from_zero.x && solution.steps == from_zero.steps && solution.value == from_zero.value,
        "the result depends on what x holds on entry");
  }

  LinearSystem homogeneous = system;
  homogeneous.name = "b = 0";
  homogeneous.b = homogeneous.solution = std::vector<double>(n, 0.0);
  const Solution zero = solve(trial, homogeneous, 1e-10, 0);
  trial.expect(zero.steps == 0 && zero.x == homogeneous.b, "b = 0 does not give x = 0 after 0 steps");

  homogeneous.name = "b = 0, epsilon = 0";
  const Solution exactly = solve(trial, homogeneous, 0, 0);
  trial.expect(exactly.steps == 0 && exactly.value == 0, "b = 0 takes steps if epsilon is 0");

  const LinearSystem identity =
      sparse_system("identity", solver::diagonal(std::vector<double>(n, 1.0)), random.normals(n), 1);
  const Solution same = solve(trial, identity, 1e-10, 0);
  trial.expect(same.steps == 0 && same.x == identity.b, "the identity does not give x = b after 0 steps");
}

void step_limit(Trial& trial) {
  Random& random = trial.random;
  const LinearSystem system =
      spectral_system("step limit", log_spaced(random.integer(20, 30), 1, 100), random);
  const auto [epsilon, steps] = tolerance_after(system, 8);

  const Solution exact = solve(trial, system, epsilon, steps);
  expect_steps(trial, exact, steps);
  expect_solved(trial, system, exact, epsilon);

  const Solution too_few = solve(trial, system, epsilon, steps - 1);
  expect_steps(trial, too_few, steps - 1);

  const Solution one = solve(trial, system, epsilon, 1);
  expect_steps(trial, one, 1);
  const Solution first = reference_solution(system, epsilon, 1);
  // x = b + alpha r with alpha = r'r / r'Ar. Here lambda_min = 1, so r'Ar, off by (e + n) u ||A|| ||r||^2, is
  // so by (e + n) u cond(A) of itself, and r, off by (e + 2) u ||A|| ||b||, reaches x through alpha <= 1:
  // four such terms twice, for either side has them.
  const double rounding = 0x1p-53 * 8 * (system.product_error + system.n()) * system.norm;
  trial.expect_at_most(distance(one.x, first.x), rounding * 2 * (norm(system.solution) + norm(system.b)),
                       "the error of x after one step");

  for (int none : {-1, -100}) {
    const Solution guess = solve(trial, system, epsilon, none);
    expect_steps(trial, guess, 0);
    trial.expect(guess.x == system.b, "without a step x is not b");
  }

  // Each 64th step takes the true residual, and moves x as any other does: along a direction to where the residual is
  // orthogonal to it. By then rounding has turned the directions, and steps differ several times in length; but each
  // ends there, within (10 + 2e) u ||A|| X for the last step's own rounding and 65 times that for the residual's.
  const LinearSystem long_way =
      spectral_system("a 64th step", log_spaced(random.integer(150, 200), 1, 1000), random);
  for (int last : {63, 64, 65, 128}) {
    std::vector<double> x = solve(trial, long_way, 0, last).x, Ax(x.size());
    const std::vector<double> before = solve(trial, long_way, 0, last - 1).x;
    long_way.A->matVecMult(x.data(), Ax.data());
    double along = 0;
    for (std::size_t i = 0; i < x.size(); ++i) along += (x[i] - before[i]) * (long_way.b[i] - Ax[i]);
    const double moved = distance(x, before),
                 expected = distance(reference_solution(long_way, 0, last).x,
                                     reference_solution(long_way, 0, last - 1).x);
    const std::string step = "step " + std::to_string(last);
    trial.expect(moved > expected / 100, "a step does not move x",
                 step + ": " + std::to_string(moved) + " instead of " + std::to_string(expected));
    trial.expect_at_most(std::abs(along), moved * 2 * drift(long_way, x, 0),
                         "the part of b - Ax that a step leaves along its direction", step);
  }

  // 0 stands for max(100, 2n), and epsilon = 0 uses all of it.
  for (int n : {20, 80}) {
    const LinearSystem endless = spectral_system("default limit", log_spaced(n, 1, 100), random);
    const int expected = reference_solution(endless, 0, 0).steps;
    expect_steps(trial, solve(trial, endless, 0, 0), expected);
  }
}

void tolerance(Trial& trial) {
  Random& random = trial.random;
  for (double scale : {1e-6, 1.0, 1e6}) {
    const LinearSystem system =
        scaled(spectral_system("tolerance", log_spaced(random.integer(30, 40), 1, 100), random), scale);
    for (int least : {1, 3, 6, 10}) {
      const auto [epsilon, steps] = tolerance_after(system, least);
      const Solution solution = solve(trial, system, epsilon, 0);
      expect_steps(trial, solution, steps);
      expect_solved(trial, system, solution, epsilon);
    }
  }

  const LinearSystem system =
      spectral_system("extreme tolerance", log_spaced(random.integer(10, 20), 1, 10), random);
  const Solution at_once = solve(trial, system, 1e10, 0);
  expect_steps(trial, at_once, 0);
  trial.expect(at_once.x == system.b, "a huge epsilon does not give x = b");
  for (double epsilon : {1e-30, 1e-300, 0.0})
    expect_solved_or_at_limit(trial, system, solve(trial, system, epsilon, 0), epsilon, 0);
}

void return_value(Trial& trial) {
  Random& random = trial.random;
  const LinearSystem system =
      spectral_system("return value", log_spaced(random.integer(30, 40), 1, 100), random);
  for (double scale : {1e-4, 1.0, 1e4}) {
    const LinearSystem scaled = grader::scaled(system, scale);
    for (int least : {2, 6, 10}) {
      const auto [epsilon, steps] = tolerance_after(scaled, least);
      const Solution solved = solve(trial, scaled, epsilon, 0);
      expect_honest_value(trial, scaled, solved);
      trial.expect(solved.value <= epsilon, "the return value of a solved system is larger than epsilon");
      expect_honest_value(trial, scaled, solve(trial, scaled, epsilon, std::max(1, steps / 2)));
    }
    expect_honest_value(trial, scaled, solve(trial, scaled, 0, -1));
  }
}

void scaling(Trial& trial) {
  const LinearSystem system =
      spectral_system("scale 1", log_spaced(trial.random.integer(8, 12), 1, 20), trial.random);
  const double epsilon = tolerance_after(system, 4).epsilon;
  const Solution plain = solve(trial, system, epsilon, 0);
  expect_solved(trial, system, plain, epsilon);
  for (int power : {-465, 465, -200, 200}) {
    LinearSystem scaled = grader::scaled(system, std::ldexp(1, power));
    scaled.name = "scale 2^" + std::to_string(power);
    const Solution solution = solve(trial, scaled, std::ldexp(epsilon, 2 * power), 0);
    trial.expect(solution.steps == plain.steps, "scaling b changes the number of steps",
                 std::to_string(solution.steps) + " instead of " + std::to_string(plain.steps));
    // Multiplying by a power of two commutes with every rounding.
    for (int i = 0; i < system.n(); ++i)
      trial.expect(solution.x[i] == std::ldexp(plain.x[i], power), "scaling b does not scale x, bit by bit");
    // An epsilon of 0 is 0 at any scale.
    trial.expect(solve(trial, scaled, 0, system.n() - 2).steps == system.n() - 2,
                 "scaling b changes the number of steps");
  }
}

}  // namespace grader::s1
