// STAFF ONLY. S1: ConjGrad's hidden cases on its arguments and its return value.
#include <algorithm>
#include <cmath>
#include <limits>

#include "grader/judge/cases/linear_system.h"
#include "reference/S1/cases.h"

namespace grader::s1 {

using solver::log_spaced;

// The same call gives the same bits, so the answers are compared with one another.
bool same(const Solution& a, const Solution& b) {
  return same_bits(a.x, b.x) && a.steps == b.steps && a.value == b.value;
}

std::optional<int> own_offset(Trial& trial) {
  // With three different eigenvalues nothing is left after three steps, however epsilon is compared, and much
  // after two: all lie within a factor of two, so that even() scales none of them to 1, where b - Ab is 0.
  const LinearSystem system =
      even(spectral_system("a count of steps", {4, 4, 5, 5, 5, 7, 7, 7, 7}, trial.random));
  std::optional<int> offset;
  trial.ask_aside([&] { offset = solve(trial, system, 1e-9, usual_limit(system)).steps - 3; });
  return offset && std::abs(*offset) <= 1 ? offset : std::nullopt;
}

bool starts_at_b(Trial& trial) {
  const LinearSystem system = spectral_system("a first guess", {2, 3, 4, 5}, trial.random);
  bool at_b = true;
  // Both the tolerance and the limit end it before a step.
  trial.ask_aside([&] { at_b = solve(trial, system, 1e10, -1).x == system.b; });
  return at_b;
}

void first_guess(Trial& trial) {
  Random& random = trial.random;
  const int n = random.integer(10, 20);
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  const LinearSystem system = even(spectral_system("any first x", log_spaced(n, 1, 30), random));
  const double reached = tolerance_after(system, 4).epsilon;
  const int limit = usual_limit(system);
  const Solution from_zero = solve(trial, system, reached, limit, std::vector<double>(n, 0.0));
  expect_solved(trial, system, from_zero, reached);
  for (const std::vector<double>& junk : {random.normals(n, 1e200), std::vector<double>(n, nan),
                                          std::vector<double>(n, infinity), system.solution, system.b})
    trial.expect(same(solve(trial, system, reached, limit, junk), from_zero),
                 "the result depends on what x holds on entry");

  const std::optional<int> offset = own_offset(trial);
  LinearSystem homogeneous = system;
  homogeneous.name = "b = 0";
  homogeneous.b = homogeneous.solution = std::vector<double>(n, 0.0);
  for (double epsilon : {1.0, 0.0}) {
    const Solution zero = solve(trial, homogeneous, epsilon, limit);
    trial.expect(zero.x == homogeneous.b && zero.products <= 1 && zero.value == 0 &&
                     (!offset || zero.steps == *offset),
                 "b = 0 does not give x = 0 and return 0 after 0 steps, though epsilon may be 0",
                 std::to_string(zero.value) + " after " + std::to_string(zero.steps));
  }

  const LinearSystem identity =
      sparse_system("identity", solver::diagonal(std::vector<double>(n, 1.0)), random.normals(n), 1);
  const Solution guess = solve(trial, identity, 1, limit);
  trial.expect(guess.x == identity.b && guess.products <= 1,
               "the identity does not give x = b after 0 steps");
}

// Only the limit decides here: epsilon is 0, or the first guess meets it, or one step in any direction does.
void step_limit(Trial& trial) {
  Random& random = trial.random;
  expect_solves_ordinary_system(trial);
  const LinearSystem system =
      scaled(spectral_system("step limit", log_spaced(random.integer(20, 30), 1, 100), random), 0x1p50);
  for (int limit : {1, 2, random.integer(3, 8)}) expect_steps(trial, solve(trial, system, 0, limit), limit);

  const bool from_b = starts_at_b(trial);
  const Solution one = solve(trial, system, 0, 1), first = reference_solution(system, 0, 1);
  // x = b + alpha r with alpha = r'r / r'Ar. Here lambda_min = 1, so r'Ar, off by (e + n) u ||A|| ||r||^2, is
  // so by (e + n) u cond(A) of itself, and r, off by (e + 2) u ||A|| ||b||, reaches x through alpha <= 1:
  // four such terms twice, for either side has them.
  const double rounding = 0x1p-53 * 8 * (system.product_error + system.n()) * system.norm;
  if (from_b)
    trial.expect_at_most(distance(one.x, first.x), rounding * 2 * (norm(system.solution) + norm(system.b)),
                         "the error of x after one step",
                         {vector_of(one.x), vector_of(first.x), 1, vector_of(system.b)});

  // The residual grows in the step that is allowed: x is the last one, and not the best.
  const std::vector<double> growth = random.uniforms(6, 1.3, 2);
  const LinearSystem grows = scaled(planned_system("a residual that grows", growth, random), 0x1p50);
  const double grown = true_residual(grows, solve(trial, grows, 0, 1).x) / true_residual(grows, grows.b);
  trial.expect(!from_b || std::abs(grown / growth[0] - 1) < 1e-6,
               "after a step that makes the residual longer, x is not that of the step",
               "residual over the expected one: " + std::to_string(grown / growth[0]));

  for (int none : {-1, -100}) {
    const Solution guess = solve(trial, system, 0, none);
    expect_steps(trial, guess, 0);
    trial.expect(!from_b || guess.x == system.b, "without a step x is not b");
  }

  // One eigenvalue takes one step; the identity takes none.
  const int n = random.integer(5, 9);
  for (double eigenvalue : {1.0, random.uniform(2, 4)}) {
    const LinearSystem multiple =
        sparse_system("a multiple of the identity", solver::diagonal(std::vector<double>(n, eigenvalue)),
                      random.normals(n), 1);
    expect_steps(trial, solve(trial, multiple, 1e-5, 50), eigenvalue == 1 && from_b ? 0 : 1);
  }

  // 0 stands for max(100, 2n). Convergence is too slow to end before.
  for (int unknowns : {20, 80}) {
    const LinearSystem endless =
        scaled(spectral_system("default limit", log_spaced(unknowns, 1e-10, 1), random), 0x1p50);
    expect_steps(trial, solve(trial, endless, 0, 0), reference_solution(endless, 0, 0).steps);
  }
}

// It ends at the first x that is good enough. If epsilon is the reached residual, nothing changes; if it is
// smaller, there are more steps. This holds for any directions and any way to count. The return value may be
// off by the drift, and epsilon leaves room for that.
void expect_ends_in_time(Trial& trial, const LinearSystem& system, double epsilon) {
  const int limit = usual_limit(system);
  const Solution solution = solve(trial, system, epsilon, limit);
  expect_solved(trial, system, solution, epsilon);
  const double reached = true_residual(system, solution.x),
               room = drift(system, solution.x, reached * reached);
  const double just = std::min(epsilon, std::pow(reached + 2 * room, 2)),
               less = std::pow(reached - 2 * room, 2);
  trial.expect(solve(trial, system, just, limit).x == solution.x,
               "it goes on although the squared norm of b - Ax is at most epsilon");
  trial.expect(solve(trial, system, less, limit).x != solution.x,
               "it ends although the squared norm of b - Ax is more than epsilon");
}

void tolerance(Trial& trial) {
  Random& random = trial.random;
  for (int power : {-100, -20, 0, 20, 100}) {
    const LinearSystem system = scaled(
        spectral_system("tolerance", log_spaced(random.integer(30, 40), 1, 5), random), std::ldexp(1, power));
    for (int least : {1, 3, 6}) expect_ends_in_time(trial, system, tolerance_after(system, least).epsilon);
  }

  const LinearSystem system =
      spectral_system("extreme tolerance", log_spaced(random.integer(100, 120), 1, 5), random);
  const bool from_b = starts_at_b(trial);
  trial.expect(solve(trial, system, 1e10, 60).x == system.b || !from_b, "a huge epsilon does not give x = b");
  const Solution to_the_limit = solve(trial, system, 0, 5);
  trial.expect(solve(trial, system, -1e10, 5).x == to_the_limit.x,
               "a negative epsilon gives another x than 0, although neither is reached");
  for (double epsilon : {1e-30, 1e-300, 0.0})
    expect_solved_or_at_limit(trial, system, solve(trial, system, epsilon, 60), epsilon, 60);
}

void return_value(Trial& trial) {
  Random& random = trial.random;
  expect_solves_ordinary_system(trial);
  const LinearSystem system =
      spectral_system("return value", log_spaced(random.integer(30, 40), 1, 100), random);
  for (int power : {-14, 0, 14})
    for (int limit : {-1, 1, 3, 7, 12}) {
      const LinearSystem scaled = grader::scaled(system, std::ldexp(1, power));
      expect_honest_value(trial, scaled, solve(trial, scaled, 0, limit));
    }
  const LinearSystem ended = even(system);
  expect_honest_value(trial, ended,
                      solve(trial, ended, tolerance_after(ended, 6).epsilon, usual_limit(ended)));

  for (double condition : {1e4, 1e8, 1e12}) {
    const LinearSystem hard =
        even(spectral_system("condition " + std::to_string(condition),
                             log_spaced(random.integer(50, 80), 1 / condition, 1), random));
    expect_honest_value(trial, hard, solve(trial, hard, 1e-16, usual_limit(hard)));
  }
  // Rounded to doubles, these may have a negative eigenvalue. CG may then end at any step, but must report
  // the residual that it reached.
  for (int size = 8; size <= 12; ++size) {
    const LinearSystem hilbert = sparse_system("Hilbert", solver::hilbert(size), random.normals(size), 0);
    expect_honest_value(trial, hilbert, solve(trial, hilbert, 0, usual_limit(hilbert)));
  }
}

void scaling(Trial& trial) {
  const LinearSystem system =
      even(spectral_system("scale 1", log_spaced(trial.random.integer(8, 12), 1, 20), trial.random));
  const double epsilon = tolerance_after(system, 4).epsilon;
  const Solution plain = solve(trial, system, epsilon, usual_limit(system));
  expect_solved(trial, system, plain, epsilon);
  for (int power : {-465, -200, 200, 465}) {
    const LinearSystem scaled = grader::scaled(system, std::ldexp(1, power));
    const Solution solution = solve(trial, scaled, std::ldexp(epsilon, 2 * power), usual_limit(system));
    trial.expect(solution.steps == plain.steps, "scaling b and epsilon changes the number of steps",
                 std::to_string(solution.steps) + " instead of " + std::to_string(plain.steps));
    // Multiplying by a power of two commutes with every rounding.
    for (int i = 0; i < system.n(); ++i)
      trial.expect(solution.x[i] == std::ldexp(plain.x[i], power), "scaling b does not scale x, bit by bit",
                   "2^" + std::to_string(power));
  }
}

}  // namespace grader::s1
