// STAFF ONLY. Lets a student's ConjGrad solve linear systems, and checks the solutions.
#include "grader/judge/cases/linear_system.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <sstream>

#include "grader/judge/cases/case_asker.h"
#include "grader/judge/cases/random.h"
#include "reference/S1/calls.h"

namespace grader::inline judge {
namespace {

int limit_of(int n, int steps) {
  return steps == 0 ? std::max(100, 2 * n) : std::max(0, steps);
}

std::string numbers(const Solution& s, double epsilon, int steps) {
  std::ostringstream text;
  text.precision(17);
  text << "epsilon " << epsilon << ", steps in " << steps << "; steps out " << s.steps << ", value "
       << s.value << ", products " << s.products;
  return text.str();
}

bool all_finite(const std::vector<double>& v) {
  return std::all_of(v.begin(), v.end(), [](double value) { return std::isfinite(value); });
}

}  // namespace

double norm(const std::vector<double>& v) {
  long double sum = 0;
  for (double value : v) sum += static_cast<long double>(value) * value;
  return static_cast<double>(std::sqrt(sum));
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> difference = a;
  for (std::size_t i = 0; i < difference.size(); ++i) difference[i] -= b[i];
  return norm(difference);
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  });
}

LinearSystem scaled(LinearSystem system, double factor) {
  for (double& value : system.b) value *= factor;
  for (double& value : system.solution) value *= factor;
  return system;
}

namespace {

// c A: each entry of a product is rounded once more.
struct Scaled : implicitMatrix {
  std::shared_ptr<implicitMatrix> A;
  double c;
  int n;

  Scaled(std::shared_ptr<implicitMatrix> matrix, double factor, int size)
      : A(std::move(matrix)), c(factor), n(size) {}
  void matVecMult(double x[], double b[]) override {
    A->matVecMult(x, b);
    for (int i = 0; i < n; ++i) b[i] *= c;
  }
};

}  // namespace

LinearSystem even(const LinearSystem& system) {
  const double c = solver::even_scale(*system.A, system.b), length = norm(system.b);
  LinearSystem result = system;
  result.A = std::make_shared<Scaled>(system.A, c, system.n());
  for (double& value : result.b) value /= length;
  for (double& value : result.solution) value /= c * length;
  result.norm *= c;
  result.smallest *= c;
  result.product_error += 1;
  return result;
}

int usual_limit(const LinearSystem& system) {
  return limit_of(system.n(), 0);
}

LinearSystem with_solution(std::string name, std::shared_ptr<implicitMatrix> A, std::vector<double> solution,
                           double norm, double smallest, double product_error) {
  LinearSystem system{std::move(name), std::move(A), {}, std::move(solution), norm, smallest, product_error};
  system.b.resize(system.solution.size());
  system.A->matVecMult(system.solution.data(), system.b.data());
  return system;
}

LinearSystem sparse_system(std::string name, const solver::SparseMatrix& A, std::vector<double> solution,
                           double smallest) {
  return with_solution(std::move(name), std::make_shared<solver::SparseMatrix>(A), std::move(solution),
                       A.norm_bound(), smallest, A.longest_row());
}

LinearSystem spectral_system(std::string name, std::vector<double> spectrum, Random& random) {
  const int n = static_cast<int>(spectrum.size());
  const auto [least, most] = std::minmax_element(spectrum.begin(), spectrum.end());
  const double smallest = *least, largest = std::max(std::abs(*least), std::abs(*most));
  constexpr int kReflectors = 3;
  std::vector<std::vector<double>> reflectors;
  for (int i = 0; i < kReflectors; ++i) reflectors.push_back(random.normals(n));
  const double product_error =
      2 * kReflectors * 2 * (n + 3);  // each reflection has a dot product and an update, twice
  return with_solution(std::move(name),
                       std::make_shared<solver::SpectralMatrix>(std::move(spectrum), std::move(reflectors)),
                       random.normals(n, 1 / std::sqrt(n)), largest, smallest, product_error);
}

LinearSystem planned_system(std::string name, const std::vector<double>& ratios, Random& random) {
  const int n = static_cast<int>(ratios.size()) + 1;
  const double scale = random.uniform(0.6, 1.9);
  std::vector<double> curvatures(n);
  for (double& value : curvatures) value = scale * random.uniform(1, 1.1);
  const solver::PlannedSystem planned = solver::planned_system(curvatures, ratios, random.normals(n));
  LinearSystem system{std::move(name), std::make_shared<solver::SparseMatrix>(planned.A), planned.b, {}};
  system.norm = planned.A.norm_bound();
  system.product_error = n;
  return system;
}

double true_residual(const LinearSystem& system, const std::vector<double>& x) {
  std::vector<double> in = x, Ax(x.size());
  system.A->matVecMult(in.data(), Ax.data());
  return distance(system.b, Ax);
}

double drift(const LinearSystem& system, const std::vector<double>& x, double value) {
  const bool known = !system.solution.empty() && system.smallest > 0;
  const double longest = 2 * std::max(norm(system.solution), known ? 0 : norm(x)) + norm(system.b);
  return kUnit *
         (65 * (10 + 2 * system.product_error) * system.norm * longest + (system.n() + 2) * std::sqrt(value));
}

Solution reference_solution(const LinearSystem& system, double epsilon, int steps) {
  Solution solution;
  solution.steps = steps;
  solution.x.resize(system.b.size());
  std::vector<double> b = system.b;
  solution.value =
      ConjGrad(system.n(), system.A.get(), solution.x.data(), b.data(), epsilon, &solution.steps);
  return solution;
}

namespace {

// Returns the tolerance that step k is clearly the first to meet, if there is one.
std::optional<Tolerance> tolerance_at(const LinearSystem& system, int k) {
  const double before = reference_solution(system, 0, k > 1 ? k - 1 : -1).value;
  const Solution reached = reference_solution(system, 0, k);
  // After the last step of exact arithmetic the residual is only rounding.
  const double after = std::max(std::sqrt(reached.value), 100 * drift(system, reached.x, reached.value));
  const double epsilon = std::sqrt(before) * after;
  // Earlier residuals may be smaller, since they need not shrink at every step.
  if (after < 0.9 * std::sqrt(before) && reference_solution(system, epsilon, k).steps == k)
    return Tolerance{epsilon, k};
  return {};
}

}  // namespace

Tolerance tolerance_after(const LinearSystem& system, int least_steps) {
  for (int k = least_steps; k < least_steps + 50; ++k)
    if (const auto tolerance = tolerance_at(system, k)) return *tolerance;
  // CG takes eigenvalues that happen to be close for one, and then ends earlier.
  for (int k = least_steps - 1; k > 0; --k)
    if (const auto tolerance = tolerance_at(system, k)) return *tolerance;
  throw std::logic_error("no clear tolerance for " + system.name);
}

Solution solve(Trial& trial, const LinearSystem& system, double epsilon, int steps, std::vector<double> x,
               int calls) {
  // Code that ignores the limit may go on to the default: the category about the step limit tests that.
  const int n = system.n(), limit = std::max(limit_of(n, steps), usual_limit(system));
  trial.describe(system.name + ", n = " + std::to_string(n));
  if (x.empty()) x = system.b;

  Solution solution;
  const auto serve = [&](int, const std::vector<double>& in, std::vector<double>& out) {
    if (in.size() != system.b.size()) throw MalformedMessage("a product that makes no sense");
    out.resize(in.size());
    std::vector<double> copy = in;
    system.A->matVecMult(copy.data(), out.data());
    return ++solution.products <= calls * (3 + 2 * limit);
  };
  std::vector<double> b = system.b;  // an earlier call's changes stay for the next one
  Eigen::Map<Eigen::VectorXd> right_side(b.data(), n);
  CaseAsker asker(trial);
  for (int call = 0; call < calls; ++call) {
    solution.x = x;
    solution.steps = steps;
    Eigen::Map<Eigen::VectorXd> result(solution.x.data(), n);
    solution.value = ask<s1::Calls, s1::conj_grad>(asker, Served{n, n, serve}, result, right_side, epsilon,
                                                   solution.steps);
  }

  // One step more than the limit is a mistake for the category about the step limit; a number further off
  // counts no steps.
  trial.expect(solution.steps >= 0 && solution.steps <= limit + 1,
               "the number of steps is negative, or far beyond the limit", numbers(solution, epsilon, steps));
  trial.expect(!all_finite(system.b) || all_finite(solution.x), "x holds values that are not finite",
               numbers(solution, epsilon, steps));
  return solution;
}

void expect_solved(Trial& trial, const LinearSystem& system, const Solution& solution, double epsilon) {
  const double residual = true_residual(system, solution.x);
  const double rounding = drift(system, solution.x, residual * residual);
  const std::string detail = numbers(solution, epsilon, 0);
  const bool known = !system.solution.empty() && system.smallest > 0;
  const Bound allowed{std::sqrt(epsilon), rounding},
      bound{allowed.promised / system.smallest, allowed.rest / system.smallest};
  Compared numbers;
  if (known)
    numbers = {vector_of(solution.x), vector_of(system.solution), 1, vector_of(system.b), bound.most()};
  trial.expect_at_most(residual, allowed, "the norm of b - Ax", numbers, detail);
  if (!known) return;
  trial.expect_at_most(distance(solution.x, system.solution), bound, "the error of x", numbers, detail);
}

void expect_steps(Trial& trial, const Solution& solution, int expected) {
  trial.expect(solution.steps == expected,
               std::string(solution.steps < expected ? "fewer" : "more") +
                   " steps than the method of conjugate gradients takes",
               "expected " + std::to_string(expected) + ", got " + std::to_string(solution.steps));
}

void expect_honest_value(Trial& trial, const LinearSystem& system, const Solution& solution) {
  const std::string detail = numbers(solution, 0, 0);
  trial.expect(solution.value >= 0, "the return value is negative, or not a number", detail);
  trial.expect_at_most(std::abs(std::sqrt(solution.value) - true_residual(system, solution.x)),
                       drift(system, solution.x, solution.value),
                       "the difference between the return value and the squared norm of b - Ax", detail);
}

void expect_solved_or_at_limit(Trial& trial, const LinearSystem& system, const Solution& solution,
                               double epsilon, int limit) {
  const double residual = true_residual(system, solution.x);
  const bool solved = residual <= std::sqrt(epsilon) + drift(system, solution.x, residual * residual);
  if (solved || solution.value <= epsilon)
    expect_solved(trial, system, solution, epsilon);
  else
    trial.expect(solution.products >= 1 + limit_of(system.n(), limit),
                 "it ends before the squared residual norm is at most epsilon, and before the step limit",
                 numbers(solution, epsilon, limit));
}

void expect_solves_ordinary_system(Trial& trial) {
  const int n = trial.random.integer(12, 20);
  const std::vector<double> spectrum = trial.random.uniforms(n, 1, 8);
  const LinearSystem system = even(spectral_system("ordinary", spectrum, trial.random));
  const double epsilon = tolerance_after(system, 4).epsilon;
  expect_solved(trial, system, solve(trial, system, epsilon, usual_limit(system)), epsilon);
}

}  // namespace grader::judge
