// STAFF ONLY. S1: ConjGrad's hidden cases on systems that it must solve.
#include "reference/S1/cases.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "grader/judge/cases/linear_system.h"

namespace grader::s1 {
namespace {

using solver::log_spaced;

// Solves with a tolerance that CG meets after a known number of steps.
Solution expect_solves(Trial& trial, const LinearSystem& any, int least_steps) {
  const LinearSystem system = even(any);
  const double epsilon = tolerance_after(system, least_steps).epsilon;
  const Solution solution = solve(trial, system, epsilon, usual_limit(system));
  expect_solved(trial, system, solution, epsilon);
  return solution;
}

// b is so large that no fixed tolerance ends the loop, and nothing meets epsilon. So the call takes `limit`
// steps, unless only rounding is left before. Then ||b - Ax|| is at most `tolerance` ||b||.
void expect_goes_on(Trial& trial, const LinearSystem& system, int limit, double tolerance = 1) {
  constexpr double kLength = 0x1p50;
  const LinearSystem large = scaled(system, kLength / norm(system.b));
  const Solution solution = solve(trial, large, 0, limit);
  expect_solved_or_at_limit(trial, large, solution, 0, limit);
  trial.expect_at_most(true_residual(large, solution.x) / kLength, tolerance,
                       "the norm of b - Ax over that of b", std::to_string(limit) + " steps");
}

// The solve takes hundreds of steps. Rounding turns the directions, which costs each right program some
// steps: 0.9 to 1.2 times ours for the systems below, with any formulas and orders of sums. A program that
// forgets its directions at each 64th or n-th step takes at least 2.4 times as many in one of them. With
// fewer unknowns chance counts more: 0.7 to 1.6 times for n = 30 and a condition of 1e6.
void expect_long_solve(Trial& trial, const LinearSystem& system) {
  const double length = norm(system.b);
  const Solution ours = reference_solution(system, std::pow(1e-8 * length, 2), 100 * system.n());
  expect_goes_on(trial, system, 2 * ours.steps, true_residual(system, ours.x) / length);
}

// Cost is graded by counts: at most two and a half times the reference's products.
void expect_solves_quickly(Trial& trial, const LinearSystem& system, int least_steps) {
  const Solution coarse = expect_solves(trial, system, least_steps);
  const int steps = tolerance_after(even(system), least_steps).steps;
  trial.expect_at_most(coarse.products, {1.0 + steps, 1.5 * (1 + steps) + 5}, "the number of products",
                       std::to_string(steps) + " steps would do");
}

LinearSystem string_of(int links, Random& random) {
  return sparse_system("string", solver::tridiagonal(links, 2, -1), random.normals(links),
                       4 * std::pow(std::sin(std::numbers::pi / (2 * (links + 1))), 2));
}

void examples(Trial& trial) {
  const LinearSystem first = sparse_system("Example 1", solver::diagonal({2, 1}), {0.5, 1}, 1);
  expect_solved(trial, first, solve(trial, first, 1e-5, starts_at_b(trial) ? 1 : 2), 1e-5);

  // The eigenvalues are (3 -+ sqrt(5)) / 2.
  const LinearSystem second = sparse_system(
      "Example 2", solver::SparseMatrix(2, 2, {{0, 0, 2}, {0, 1, 1}, {1, 0, 1}, {1, 1, 1}}), {-1, 5}, 0.38);
  expect_solved(trial, second, solve(trial, second, 1e-5, 2), 1e-5);
}

// k different eigenvalues take k steps, and no more are allowed.
void clusters(Trial& trial) {
  Random& random = trial.random;
  for (int distinct = 1; distinct <= 6; ++distinct) {
    const int n = random.integer(100, 200);
    std::vector<double> spectrum(n);
    for (int i = 0; i < n; ++i) spectrum[i] = 1.5 * (1 + i % distinct);
    const LinearSystem system =
        spectral_system(std::to_string(distinct) + " different eigenvalues", spectrum, random);
    expect_goes_on(trial, system, distinct, 1e-9);
  }
}

void stiff_strands(Trial& trial) {
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
    const LinearSystem system =
        sparse_system("strand", solver::strand_implicit_euler(masses, axial, bending, h),
                      random.normals(3 * segments, 0.1), *std::min_element(masses.begin(), masses.end()));
    expect_goes_on(trial, system, 3000);
  }
}

void ill_conditioned(Trial& trial) {
  Random& random = trial.random;
  for (double condition : {1e4, 1e6, 1e8, 1e10, 1e12}) {
    const LinearSystem system = spectral_system("condition " + std::to_string(condition),
                                                log_spaced(random.integer(50, 80), 1 / condition, 1), random);
    expect_goes_on(trial, system, usual_limit(system));
  }
  // Lower bounds of the smallest eigenvalues: 1 / ||H^-1||_F.
  const double hilbert_smallest[] = {9.6e-5, 3.2e-6, 1.0e-7, 3.4e-9};
  for (int size = 4; size <= 7; ++size) {
    const LinearSystem hilbert =
        sparse_system("Hilbert", solver::hilbert(size), random.normals(size), hilbert_smallest[size - 4]);
    expect_solves(trial, hilbert, 2);
    expect_goes_on(trial, hilbert, usual_limit(hilbert));
  }
}

}  // namespace

void systems(Trial& trial) {
  Random& random = trial.random;
  examples(trial);
  clusters(trial);

  // It has fewer different eigenvalues than unknowns, and takes at most 64 steps; another category is about
  // the 64th.
  const int grid = random.integer(9, 14);
  const LinearSystem poisson =
      sparse_system("2-D Poisson", solver::poisson_2d(grid), random.normals(grid * grid),
                    8 * std::pow(std::sin(std::numbers::pi / (2 * (grid + 1))), 2));
  expect_solves_quickly(trial, poisson, random.integer(9, 12));
  const LinearSystem spectral =
      spectral_system("random", random.uniforms(random.integer(150, 200), 1, 16), random);
  expect_solves_quickly(trial, spectral, random.integer(6, 8));

  const solver::SparseMatrix tridiagonal = solver::tridiagonal(random.integer(20, 30), 3, -1);
  expect_solves_quickly(trial,
                        sparse_system("tridiagonal", tridiagonal, random.normals(tridiagonal.rows()), 1), 4);

  // A strand that is light and limp enough for the number of steps to be certain.
  const int segments = random.integer(10, 20);
  const double mass = random.log_uniform(1e-8, 1e-7);
  expect_solves_quickly(
      trial,
      sparse_system("light strand",
                    solver::strand_implicit_euler(std::vector<double>(segments, mass), 2e-2 * mass / 1e-6,
                                                  1e-3 * mass / 1e-6, 1e-2),
                    random.normals(3 * segments, 0.1), mass),
      3);
}

// Conditions are at most 4, so that a program that converges slowly passes, too, if it reaches all unknowns.
void sizes(Trial& trial) {
  for (int n : {1, 2, 3, 10, 100, 1000, 10000}) {
    const std::vector<double> d = trial.random.uniforms(n, 1, 4);
    const LinearSystem diagonal = sparse_system("diagonal", solver::diagonal(d), trial.random.normals(n),
                                                *std::min_element(d.begin(), d.end()));
    const double sign = trial.random.integer(0, 1) == 0 ? -1 : 1;
    const double off = sign * trial.random.uniform(0.4, 0.5);
    const LinearSystem tridiagonal = sparse_system("tridiagonal", solver::tridiagonal(n, 2, off),
                                                   trial.random.normals(n), 2 - 2 * std::abs(off));
    for (const LinearSystem* system : {&diagonal, &tridiagonal}) {
      expect_solves(trial, *system, std::min((n + 1) / 2, 4));
    }
  }
}

// The residual stays as long as it is for one step or for many, or grows, before it falls to 0 in the last
// step.
void plateaus(Trial& trial) {
  Random& random = trial.random;
  std::vector<double> once = random.uniforms(7, 0.4, 0.9), rises = random.uniforms(8, 1.1, 2);
  once[random.integer(0, 6)] = 1;
  for (std::size_t i = 4; i < rises.size(); ++i) rises[i] = random.uniform(0.3, 0.8);
  for (const std::vector<double>& ratios : {once, rises, std::vector<double>(random.integer(8, 20), 1)}) {
    const int n = static_cast<int>(ratios.size()) + 1;
    expect_goes_on(trial, planned_system("a residual that does not fall in each step", ratios, random), n + 2,
                   1e-6);
  }
}

// Systems that need more steps than they have unknowns, or hundreds.
void hard(Trial& trial) {
  Random& random = trial.random;
  expect_solves_ordinary_system(trial);
  plateaus(trial);
  stiff_strands(trial);
  ill_conditioned(trial);
  expect_goes_on(trial, string_of(random.integer(40, 60), random), 200, 1e-10);
  expect_long_solve(trial, string_of(random.integer(300, 400), random));
  expect_long_solve(trial, spectral_system("random, condition 5000",
                                           log_spaced(random.integer(250, 300), 1, 5000), random));
  // This takes far more steps than unknowns, since rounding turns the directions.
  expect_long_solve(
      trial, spectral_system("random, condition 1e6", log_spaced(random.integer(60, 80), 1, 1e6), random));
}

// A program that solves no ordinary system gets no points here.
void empty(Trial& trial) {
  expect_solves_ordinary_system(trial);
  const LinearSystem nothing = sparse_system("nothing", solver::diagonal({}), {}, 1);
  for (double epsilon : {0.0, 1.0, -1.0})
    for (int most_steps : {0, trial.random.integer(1, 50), -trial.random.integer(1, 50)}) {
      const Solution empty = solve(trial, nothing, epsilon, most_steps);
      trial.expect(empty.value == 0 && empty.steps == 0, "n = 0 does not return 0 after 0 steps",
                   std::to_string(empty.value) + " after " + std::to_string(empty.steps) + " of " +
                       std::to_string(most_steps));
    }
}

}  // namespace grader::s1
