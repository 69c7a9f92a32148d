// STAFF ONLY. S1: ConjGrad's hidden cases on systems that it must solve. Those that it can't are in
// s1_extremes.cpp.
#include "grader/suite/s1_categories.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "grader/suite/linear_system.h"
#include "solver/matrix_market.h"

namespace grader::s1 {
namespace {

using solver::log_spaced;

std::vector<double> uniform_values(Random& random, int n, double low, double high) {
  std::vector<double> values(n);
  for (double& value : values) value = random.uniform(low, high);
  return values;
}

// At a tolerance that CG meets after a certain number of steps, and at one that is close to the rounding
// errors. Cost is graded by counts: at most two and a half times the reference's products.
void expect_solves(Trial& trial, const LinearSystem& system, int least_steps) {
  const auto [epsilon, steps] = tolerance_after(system, least_steps);
  const Solution coarse = solve(trial, system, epsilon, 0);
  expect_solved(trial, system, coarse, epsilon);
  if (!system.ill_conditioned)
    trial.expect_at_most(coarse.products, 2.5 * (1 + steps) + 5, "the number of products",
                         std::to_string(steps) + " steps would do");

  const double fine = std::pow(1e-10 * norm(system.b), 2);
  expect_solved_or_at_limit(trial, system, solve(trial, system, fine, 0), fine, 0);
}

}  // namespace

void examples(Trial& trial) {
  LinearSystem first = sparse_system("Example 1", solver::diagonal({2, 1}), {0.5, 1}, 1);
  const Solution one = solve(trial, first, 1e-5, 100, {0, 0});
  expect_steps(trial, one, 1);
  expect_solved(trial, first, one, 1e-5);

  // Eigenvalues (3 -+ sqrt(5)) / 2.
  LinearSystem second = sparse_system(
      "Example 2", solver::SparseMatrix(2, 2, {{0, 0, 2}, {0, 1, 1}, {1, 0, 1}, {1, 1, 1}}), {-1, 5}, 0.38);
  const Solution two = solve(trial, second, 1e-5, 100, {0, 0});
  expect_steps(trial, two, 2);
  expect_solved(trial, second, two, 1e-5);

  for (int n = 2; n <= 4; ++n) {
    std::vector<double> spectrum;
    for (int i = 1; i <= n; ++i) spectrum.push_back(i + trial.random.uniform(0, 0.3));
    const LinearSystem system = scaled(spectral_system("like the examples", spectrum, trial.random), 1e4);
    const double epsilon = std::pow(1e-8 * norm(system.b), 2);
    const Solution solution = solve(trial, system, epsilon, 100);
    expect_steps(trial, solution, n);  // n different eigenvalues
    expect_solved(trial, system, solution, epsilon);
  }
}

void sizes(Trial& trial) {
  LinearSystem nothing = sparse_system("nothing", solver::diagonal({}), {}, 1);
  const Solution empty = solve(trial, nothing, 0, 0);
  trial.expect(empty.value == 0 && empty.steps == 0, "n = 0 does not return 0 after 0 steps",
               std::to_string(empty.value));

  for (int n : {1, 2, 3, 10, 100, 1000, 10000}) {
    const std::vector<double> d = uniform_values(trial.random, n, 1, 20);
    const LinearSystem diagonal = sparse_system("diagonal", solver::diagonal(d), trial.random.normals(n),
                                                *std::min_element(d.begin(), d.end()));
    expect_solves(trial, diagonal, std::min(n, 16));
    const double off = (trial.random.integer(0, 1) == 0 ? -1 : 1) * trial.random.uniform(0.5, 0.9);
    const LinearSystem tridiagonal = sparse_system("tridiagonal", solver::tridiagonal(n, 2, off),
                                                   trial.random.normals(n), 2 - 2 * std::abs(off));
    expect_solves(trial, tridiagonal, std::min((n + 1) / 2, 10));
  }
}

void known_matrices(Trial& trial) {
  Random& random = trial.random;
  const int grid = random.integer(9, 14);
  expect_solves(trial,
                sparse_system("2-D Poisson", solver::poisson_2d(grid), random.normals(grid * grid),
                              8 * std::pow(std::sin(std::numbers::pi / (2 * (grid + 1))), 2)),
                random.integer(16, 20));

  const int n = random.integer(40, 60);
  const double least = 4 * std::pow(std::sin(std::numbers::pi / (2 * (n + 1))), 2);
  expect_solves(trial, sparse_system("string", solver::tridiagonal(n, 2, -1), random.normals(n), least), 20);

  for (double condition : {1e2, 1e3})
    expect_solves(trial,
                  spectral_system("random, condition " + std::to_string(condition),
                                  log_spaced(random.integer(40, 80), 1, condition), random),
                  random.integer(16, 20));

  // Smallest eigenvalues, from below: 1 / ||H^-1||_F.
  const double hilbert_smallest[] = {9.6e-5, 3.2e-6, 1.0e-7, 3.4e-9};
  for (int size = 4; size <= 7; ++size)
    expect_solves(
        trial,
        sparse_system("Hilbert", solver::hilbert(size), random.normals(size), hilbert_smallest[size - 4]), 2);

  std::stringstream file;
  solver::write_matrix_market(file, solver::tridiagonal(random.integer(20, 30), 3, -1));
  const solver::SparseMatrix from_file = solver::read_matrix_market(file, "generated");
  expect_solves(trial, sparse_system("from a file", from_file, random.normals(from_file.rows()), 1), 6);
}

void ill_conditioned(Trial& trial) {
  Random& random = trial.random;
  expect_solves_ordinary_system(trial);
  for (double condition : {1e4, 1e6, 1e8, 1e10, 1e12}) {
    const LinearSystem system = spectral_system("condition " + std::to_string(condition),
                                                log_spaced(random.integer(50, 80), 1 / condition, 1), random);
    for (double tolerance : {1e-3, 1e-8}) {
      const double epsilon = std::pow(tolerance * norm(system.b), 2);
      const Solution solution = solve(trial, system, epsilon, 0);
      expect_solved_or_at_limit(trial, system, solution, epsilon, 0);
      expect_honest_value(trial, system, solution);
      expect_counted_products(trial, system, solution);
    }
  }
  // Rounded to doubles, these may have a negative eigenvalue: where CG then ends is open, but not that it
  // says what it has reached.
  for (int size = 8; size <= 12; ++size) {
    const LinearSystem system = sparse_system("Hilbert", solver::hilbert(size), random.normals(size), 0);
    for (double epsilon : {std::pow(1e-8 * norm(system.b), 2), 0.0}) {
      const Solution solution = solve(trial, system, epsilon, 0);
      expect_honest_value(trial, system, solution);
      expect_counted_products(trial, system, solution);
    }
  }
}

void clusters(Trial& trial) {
  Random& random = trial.random;
  for (int distinct = 1; distinct <= 6; ++distinct) {
    const int n = random.integer(100, 200);
    std::vector<double> spectrum(n);
    for (int i = 0; i < n; ++i) spectrum[i] = 1.5 * (1 + i % distinct);
    const LinearSystem system =
        spectral_system(std::to_string(distinct) + " different eigenvalues", spectrum, random);
    const double epsilon = std::pow(1e-9 * norm(system.b), 2);
    const Solution solution = solve(trial, system, epsilon, 0);
    expect_steps(trial, solution, distinct);
    expect_solved(trial, system, solution, epsilon);
  }
}

void stiff_strand(Trial& trial) {
  Random& random = trial.random;
  const double radius = 50e-6, young = 3e9;  // human hair
  for (double length : {0.3, 0.1}) {
    const int segments = random.integer(20, 40);
    const double l = length / segments, h = 1.0 / 60;
    const double axial = young * std::numbers::pi * radius * radius / l;
    const double bending = young * std::numbers::pi * std::pow(radius, 4) / 4 / (l * l * l);
    std::vector<double> masses(segments);
    for (double& mass : masses) mass = random.log_uniform(1e-8, 1);
    // The solution is a velocity for each particle. The smallest eigenvalue is at least the smallest mass.
    std::vector<double> velocities = random.normals(3 * segments, 0.1);
    const LinearSystem system =
        sparse_system("strand", solver::strand_implicit_euler(masses, axial, bending, h), velocities,
                      *std::min_element(masses.begin(), masses.end()));
    for (double tolerance : {1e-4, 1e-10}) {
      const double epsilon = std::pow(tolerance * norm(system.b), 2);
      expect_solved_or_at_limit(trial, system, solve(trial, system, epsilon, 3000), epsilon, 3000);
    }
  }
  // Light and limp enough that the number of steps is certain: an absolute tolerance would find it solved at
  // once.
  const int segments = random.integer(10, 20);
  const double mass = random.log_uniform(1e-8, 1e-7);
  const LinearSystem light =
      sparse_system("light strand",
                    solver::strand_implicit_euler(std::vector<double>(segments, mass), 2e-2 * mass / 1e-6,
                                                  1e-3 * mass / 1e-6, 1e-2),
                    random.normals(3 * segments, 0.1), mass);
  expect_solves(trial, light, 3);
}

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
  }
}

}  // namespace grader::s1
