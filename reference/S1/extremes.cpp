// STAFF ONLY. S1: ConjGrad's hidden cases on systems that it can't solve, on the 64th step, and on repeated
// calls.
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "grader/judge/cases/linear_system.h"
#include "reference/S1/cases.h"

namespace grader::s1 {
namespace {

// A tridiagonal matrix whose product is `value` at unknown `at` once its input reaches this unknown. Each
// step reaches one unknown more, so the step that fails does not depend on a program's number of products.
class PoisonedMatrix : public implicitMatrix {
 public:
  PoisonedMatrix(int n, int at, double value)
      : inside_(solver::tridiagonal(n, 3, -1)), at_(at), value_(value) {}

  void matVecMult(double x[], double b[]) override {
    inside_.matVecMult(x, b);
    if (x[at_] != 0) b[at_] = value_;
  }

 private:
  solver::SparseMatrix inside_;
  int at_;
  double value_;
};

// Multiplies by `inside`, but one product is all NaN.
class LatePoison : public implicitMatrix {
 public:
  LatePoison(std::shared_ptr<implicitMatrix> inside, int at) : inside_(std::move(inside)), left_(at) {}

  void matVecMult(double x[], double b[]) override {
    inside_->matVecMult(x, b);
    if (--left_ == 0) b[0] = std::numeric_limits<double>::quiet_NaN();
  }

 private:
  std::shared_ptr<implicitMatrix> inside_;
  int left_;
};

LinearSystem with_right_side(std::string name, const solver::SparseMatrix& A, std::vector<double> b) {
  LinearSystem system{std::move(name), std::make_shared<solver::SparseMatrix>(A), std::move(b), {}};
  system.norm = A.norm_bound();
  system.product_error = A.longest_row();
  return system;
}

// It ended in step `step`, and does not claim to have solved anything.
void expect_failed(Trial& trial, const Solution& solution, double epsilon, int step,
                   std::optional<int> offset) {
  trial.expect(!offset || solution.steps == step + *offset,
               "the iteration that fails is not the last one, or does not count once",
               "expected " + std::to_string(step) + ", got " + std::to_string(solution.steps));
  trial.expect(!(solution.value <= epsilon), "the return value is at most epsilon although nothing is solved",
               std::to_string(solution.value));
}

// It did not count that step's x, which is known if it began at b.
void expect_breakdown(Trial& trial, const LinearSystem& system, const Solution& solution, double epsilon,
                      int step, const std::vector<double>& x, std::optional<int> offset, bool from_b) {
  expect_failed(trial, solution, epsilon, step, offset);
  // x is b after no step, or b + alpha r after one in two dimensions: some twenty roundings.
  if (from_b)
    trial.expect_at_most(distance(solution.x, x), 64 * 0x1p-53 * (norm(x) + norm(system.b)),
                         "the error of the x that it ends with");
}

// Values near the largest double, some of which overflow. For A = a I the first direction is r = b - Ax =
// b (1 - a), alpha is 1 / a, and the next x is b / a.
void where_numbers_end(Trial& trial, std::optional<int> offset, bool from_b) {
  Random& random = trial.random;
  const auto diagonal = [](std::string name, const std::vector<double>& d, std::vector<double> b) {
    return with_right_side(std::move(name), solver::diagonal(d), std::move(b));
  };
  const double size = random.uniform(1, 3);
  for (const LinearSystem& system : {diagonal("x overflows", {1e-200, 1e-200}, {size * 1e150, 1e150}),
                                     diagonal("one entry of x overflows", {2, 1e-200}, {size, 1e150}),
                                     diagonal("the other entry of x overflows", {1e-200, 2}, {1e150, size}),
                                     diagonal("alpha overflows", {4e-309, 4e-309}, {size, 1})}) {
    const Solution solution = solve(trial, system, 1e-12, 50);
    expect_breakdown(trial, system, solution, 1e-12, 1, system.b, offset, from_b);
  }
  // Sums in long double have a wider range: then d'Ad and all else are finite, and the system is solved. If
  // d'Ad is infinite and the loop still goes on, x stays b: a residual of 1e150, where 1e137 is allowed.
  const LinearSystem wide = diagonal("d'Ad overflows", {1e10, 2e10}, {size * 1e140, 1e140});
  const Solution gone_on = solve(trial, wide, 1e-12, 50);
  if (gone_on.x == wide.b)
    expect_breakdown(trial, wide, gone_on, 1e-12, 1, wide.b, offset, from_b);
  else
    expect_solved(trial, wide, gone_on, 1e-12);
  // A solution near the largest double, 1.8e308, is still a solution.
  const double b = random.uniform(1, 2) * 1e150;
  const LinearSystem large = diagonal("x is 1e308", {1.25e-158, 1.25e-158}, {b, 1e150});
  const Solution solution = solve(trial, large, 0, 1);
  trial.expect_at_most(std::abs(solution.x[0] / (8e157 * b) - 1) + std::abs(solution.x[1] / 8e307 - 1), 1e-14,
                       "the relative error of an x near the end of the numbers");
  // For diag(s, 2 s) and equal entries b, x is two thirds of b / s after one step, and (1, 1/2) of it after
  // two. That overflows here, so x stays the same. The residual of the first x would lead to (1/3, 5/6) of
  // it, which is finite.
  const double end = 1.05e308, s = b / end / 2;
  const LinearSystem last = diagonal("x overflows in the second step", {s, 2 * s}, {b, b});
  const Solution stays = solve(trial, last, 1e-12, 50);
  expect_failed(trial, stays, 1e-12, 2, offset);
  trial.expect_at_most(
      std::abs(stays.x[0] / (4 * (end / 3)) - 1) + std::abs(stays.x[1] / (4 * (end / 3)) - 1), 1e-14,
      "the relative error of the last x that is a number");
}

}  // namespace

void not_positive_definite(Trial& trial) {
  Random& random = trial.random;
  expect_solves_ordinary_system(trial);
  const std::optional<int> offset = own_offset(trial);
  const bool from_b = starts_at_b(trial);
  const double epsilon = 1e-12;
  const int n = random.integer(5, 9);

  // The first direction already has d'Ad <= 0, so the first step fails, and x = b.
  const std::vector<double> b = random.normals(n);
  const LinearSystem negative = with_right_side(
      "negative definite", solver::diagonal(std::vector<double>(n, -random.uniform(0.5, 3))), b);
  expect_breakdown(trial, negative, solve(trial, negative, epsilon, 50), epsilon, 1, b, offset, from_b);
  const LinearSystem zero = with_right_side("zero matrix", solver::diagonal(std::vector<double>(n, 0.0)), b);
  expect_breakdown(trial, zero, solve(trial, zero, epsilon, 50), epsilon, 1, b, offset, from_b);

  // diag(p, -q) has first r = (1, s), with d'Ad = p - q s^2 > 0. The second direction has d'Ad < 0, by
  // Sylvester's law of inertia, and so has the second residual, a multiple of (-s, 1), since p s^2 < q.
  const double p = random.uniform(4, 6), q = random.uniform(1, 2), s = random.uniform(0.2, 0.3);
  const LinearSystem indefinite =
      with_right_side("indefinite", solver::diagonal({p, -q}), {1 / (1 - p), s / (1 + q)});
  const double alpha = (1 + s * s) / (p - q * s * s);
  expect_breakdown(trial, indefinite, solve(trial, indefinite, epsilon, 50), epsilon, 2,
                   {indefinite.b[0] + alpha, indefinite.b[1] + alpha * s}, offset, from_b);

  // The matrix is singular: it has the eigenvalue 0 once, for the vector of ones.
  const int size = random.integer(6, 10);
  std::vector<solver::SparseMatrix::Entry> ring;
  for (int i = 0; i < size; ++i) {
    ring.push_back({i, i, 2});
    ring.push_back({i, (i + 1) % size, -1});
    ring.push_back({i, (i + size - 1) % size, -1});
  }
  const solver::SparseMatrix laplacian(size, size, ring);
  // Rounding decides at which step CG ends. It must end, with a finite x and a true residual.
  const LinearSystem consistent =
      sparse_system("semi-definite, consistent", laplacian, random.normals(size), 0);
  LinearSystem inconsistent = with_right_side("semi-definite, inconsistent", laplacian, random.normals(size));
  double mean = 0;
  for (double value : inconsistent.b) mean += value / size;
  for (double& value : inconsistent.b) value += 1 - mean;  // no x can reach a mean of 1
  for (const LinearSystem* singular : {&consistent, &std::as_const(inconsistent)}) {
    const Solution solution = solve(trial, *singular, epsilon, 100);
    if (solution.value <= epsilon) expect_solved(trial, *singular, solution, epsilon);
  }
}

void not_finite(Trial& trial) {
  Random& random = trial.random;
  expect_solves_ordinary_system(trial);
  const std::optional<int> offset = own_offset(trial);
  const bool from_b = starts_at_b(trial);
  const auto expect_no_step = [&](const Solution& solution) {
    trial.expect(solution.products <= 1 && (!offset || solution.steps == *offset),
                 "the first residual is not finite, and yet it takes a step, or counts one",
                 std::to_string(solution.steps) + " steps");
  };
  const int n = random.integer(10, 14);
  for (double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                       -std::numeric_limits<double>::infinity()}) {
    LinearSystem bad_b = with_right_side("b is not finite", solver::tridiagonal(n, 3, -1), random.normals(n));
    bad_b.b[random.integer(0, n - 1)] = value;
    const Solution nothing = solve(trial, bad_b, 1, 50);
    expect_no_step(nothing);
    trial.expect(!std::isfinite(nothing.value), "b is not finite, and yet the return value is");

    // b has its first `reach` entries, the first residual one more, and the direction of step k has k more
    // than b.
    for (int failing : {0, 1, 3}) {
      if (!from_b) break;
      const int reach = random.integer(2, 3), at = failing == 0 ? reach - 1 : reach + failing - 1;
      LinearSystem poisoned =
          with_right_side("a product is not finite", solver::tridiagonal(n, 3, -1), random.normals(n));
      for (int i = reach; i < n; ++i) poisoned.b[i] = 0;
      poisoned.A = std::make_shared<PoisonedMatrix>(n, at, value);
      const Solution solution = solve(trial, poisoned, 1e-12, 50);
      trial.expect(!(solution.value <= 1e-12),
                   "a product is not finite, and yet the return value is at most epsilon");
      if (failing == 0) {
        expect_no_step(solution);
        trial.expect(solution.x == poisoned.b, "without a step x is not b");
        continue;
      }
      expect_failed(trial, solution, 1e-12, failing, offset);
      // Only the steps before the failing one have moved x.
      for (int i = reach; i < n; ++i)
        trial.expect((solution.x[i] != 0) == (i < at), "x is not the last finite one",
                     "entry " + std::to_string(i) + " is " + std::to_string(solution.x[i]));
    }
  }
  where_numbers_end(trial, offset, from_b);

  // The 66th product makes the true residual after 64 steps. ConjGrad ends with an x, and solve() checks
  // nothing else.
  LinearSystem late =
      spectral_system("the 66th product is not finite", solver::log_spaced(220, 1, 1000), random);
  late.A = std::make_shared<LatePoison>(late.A, 66);
  solve(trial, late, 0, 100);
}

// Compares products and x at the step that takes the true residual, and around it. With epsilon = 0 it goes
// on to the limit.
void sixty_fourth(Trial& trial) {
  Random& random = trial.random;
  expect_solves_ordinary_system(trial);
  // No residual is longer than the one before, so the best x is always the last one.
  const LinearSystem system = scaled(
      planned_system("the 64th step", random.uniforms(random.integer(132, 138), 0.9, 0.95), random), 0x1p50);
  for (int steps : {1, 63, 64, 65, 127, 128, 129}) {
    const Solution solution = solve(trial, system, 0, steps);
    trial.expect(solution.products == 1 + steps + steps / 64,
                 "the number of products is not 1 + steps + floor(steps / 64)",
                 std::to_string(solution.products) + " for " + std::to_string(steps) + " steps");
  }
  // The same holds if epsilon ends it, for any way to count.
  const LinearSystem ends =
      even(spectral_system("ended by epsilon", solver::log_spaced(random.integer(20, 30), 1, 50), random));
  const auto [epsilon, least] = tolerance_after(ends, 5);
  const Solution ended = solve(trial, ends, epsilon, usual_limit(ends));
  trial.expect(ended.products == 1 + ended.steps + ended.steps / 64 || ended.products == 1 + least,
               "it takes one product more than its steps need", std::to_string(ended.products) + " products");

  // Each 64th step moves x like any other: along a direction until the residual is orthogonal to it. By then
  // rounding has turned the directions, and steps differ several times in length. But each ends there, within
  // (10 + 2e) u ||A|| X for the last step's own rounding and 65 times that for the residual's.
  for (int last : {63, 64, 65, 128}) {
    std::vector<double> x = solve(trial, system, 0, last).x, Ax(x.size());
    const std::vector<double> before = solve(trial, system, 0, last - 1).x;
    system.A->matVecMult(x.data(), Ax.data());
    double along = 0;
    for (std::size_t i = 0; i < x.size(); ++i) along += (x[i] - before[i]) * (system.b[i] - Ax[i]);
    const double moved = distance(x, before), expected = distance(reference_solution(system, 0, last).x,
                                                                  reference_solution(system, 0, last - 1).x);
    const std::string step = "step " + std::to_string(last);
    trial.expect(moved > expected / 100, "a step does not move x",
                 step + ": " + std::to_string(moved) + " instead of " + std::to_string(expected));
    trial.expect_at_most(std::abs(along), moved * 2 * drift(system, x, 0),
                         "the part of b - Ax that a step leaves along its direction", step);
  }
}

// Compares each answer with that of the same call before.
void call_after_call(Trial& trial) {
  Random& random = trial.random;
  const int n = random.integer(10, 20);
  const double epsilon = 1e-3;
  const auto drawn = [&](const std::string& name, int unknowns, double condition) {
    return even(spectral_system(name, solver::log_spaced(unknowns, 1, condition), random));
  };
  const LinearSystem first = drawn("first", n, 40), larger = drawn("second, larger", 3 * n, 80),
                     smaller = drawn("third, smaller", n / 2, 10);
  const auto ask = [&](const LinearSystem& system) {
    return solve(trial, system, epsilon, usual_limit(system));
  };
  const Solution before = ask(first);
  expect_solved(trial, first, before, epsilon);
  // It takes forty steps, and forty more, none of which is a 64th.
  const Solution forty = solve(trial, larger, 0, 40);
  for (const LinearSystem* other : {&larger, &smaller}) {
    expect_solved(trial, *other, ask(*other), epsilon);
    const Solution many = solve(trial, larger, 0, 40), after = ask(first);
    trial.expect(many.x == forty.x && many.steps == forty.steps && many.products == forty.products &&
                     after.x == before.x && after.steps == before.steps && after.value == before.value,
                 "the same call gives another result the second time");
  }
  // The second call finds b as it was.
  trial.expect(solve(trial, first, epsilon, usual_limit(first), {}, 2).x == before.x,
               "a second call with the same b gives another x");
}

}  // namespace grader::s1
