// STAFF ONLY. S1: ConjGrad's hidden cases on what it can't solve, and on how it goes about its work.
#include <cmath>
#include <limits>

#include "grader/exercise/S1/cases.h"
#include "grader/suite/linear_system.h"

namespace grader::s1 {
namespace {

// The matrix inside, but for product number `at` (counted from 1), which holds `value` in one place.
class PoisonedMatrix : public implicitMatrix {
 public:
  PoisonedMatrix(std::shared_ptr<implicitMatrix> inside, int at, double value)
      : inside_(std::move(inside)), at_(at), value_(value) {}

  void matVecMult(double x[], double b[]) override {
    inside_->matVecMult(x, b);
    if (++count_ == at_) b[0] = value_;
  }

 private:
  std::shared_ptr<implicitMatrix> inside_;
  int at_, count_ = 0;
  double value_;
};

LinearSystem with_right_side(std::string name, const solver::SparseMatrix& A, std::vector<double> b) {
  LinearSystem system{std::move(name), std::make_shared<solver::SparseMatrix>(A), std::move(b), {}};
  system.norm = A.norm_bound();
  system.product_error = A.longest_row();
  return system;
}

// It ended at step `steps`, did not count that step's x, and does not claim to have solved anything.
void expect_breakdown(Trial& trial, const LinearSystem& system, const Solution& solution, double epsilon,
                      int steps, const std::vector<double>& x) {
  expect_steps(trial, solution, steps);
  trial.expect(!(solution.value <= epsilon), "the return value is at most epsilon although nothing is solved",
               std::to_string(solution.value));
  // x is b after no step, or b + alpha r after one in two dimensions: some twenty roundings.
  trial.expect_at_most(distance(solution.x, x), 64 * 0x1p-53 * (norm(x) + norm(system.b)),
                       "the error of the x that it ends with");
}

// What is finite on paper and what is not, where numbers end. The first direction is r = b - Ax = b (1 - a) of A = a I,
// alpha is 1 / a, and the next x is b / a.
void where_numbers_end(Trial& trial) {
  Random& random = trial.random;
  const auto diagonal = [](std::string name, const std::vector<double>& d, std::vector<double> b) {
    return with_right_side(std::move(name), solver::diagonal(d), std::move(b));
  };
  const double size = random.uniform(1, 3);
  for (const LinearSystem& system : {diagonal("x overflows", {1e-200, 1e-200}, {size * 1e150, 1e150}),
                                     diagonal("one entry of x overflows", {2, 1e-200}, {size, 1e150}),
                                     diagonal("the other entry of x overflows", {1e-200, 2}, {1e150, size}),
                                     diagonal("alpha overflows", {4e-309, 4e-309}, {size, 1})}) {
    const Solution solution = solve(trial, system, 1e-12, 0);
    expect_breakdown(trial, system, solution, 1e-12, 1, system.b);
  }
  // Sums in long double have a wider range: then d'Ad is finite, and so is all else, and the system is solved. Where it is
  // not, and the loop goes on all the same, x stays b: a residual of 1e150, and 1e137 is allowed.
  const LinearSystem wide = diagonal("d'Ad overflows", {1e10, 2e10}, {size * 1e140, 1e140});
  const Solution gone_on = solve(trial, wide, 1e-12, 0);
  if (gone_on.steps == 1)
    expect_breakdown(trial, wide, gone_on, 1e-12, 1, wide.b);
  else
    expect_solved(trial, wide, gone_on, 1e-12);
  // A solution near the end of the numbers, 1.8e308, is one.
  const double b = random.uniform(1, 2) * 1e150;
  const LinearSystem large = diagonal("x is 1e308", {1.25e-158, 1.25e-158}, {b, 1e150});
  const Solution solution = solve(trial, large, 1e280, 0);
  expect_steps(trial, solution, 1);
  trial.expect_at_most(std::abs(solution.x[0] / (8e157 * b) - 1) + std::abs(solution.x[1] / 8e307 - 1), 1e-14,
                       "the relative error of an x near the end of the numbers");
  // Of diag(s, 2 s) with equal entries b, x is two thirds of b / s after one step, and (1, 1/2) of it after two: here that is where numbers
  // have ended, so x stays what it was. The way back, (1/3, 5/6) of it, has numbers.
  const double end = 1.05e308, s = b / end / 2;
  const LinearSystem last = diagonal("x overflows in the second step", {s, 2 * s}, {b, b});
  const Solution stays = solve(trial, last, 1e-12, 0);
  expect_steps(trial, stays, 2);
  trial.expect(!(stays.value <= 1e-12), "the return value is at most epsilon although nothing is solved",
               std::to_string(stays.value));
  trial.expect_at_most(
      std::abs(stays.x[0] / (4 * (end / 3)) - 1) + std::abs(stays.x[1] / (4 * (end / 3)) - 1), 1e-14,
      "the relative error of the last x that is a number");
}

}  // namespace

void not_positive_definite(Trial& trial) {
  Random& random = trial.random;
  expect_solves_ordinary_system(trial);
  const double epsilon = 1e-12;
  const int n = random.integer(5, 9);

  // The first direction already has d'Ad <= 0: one step that fails, and x = b.
  const std::vector<double> b = random.normals(n);
  const LinearSystem negative = with_right_side(
      "negative definite", solver::diagonal(std::vector<double>(n, -random.uniform(0.5, 3))), b);
  expect_breakdown(trial, negative, solve(trial, negative, epsilon, 0), epsilon, 1, b);
  const LinearSystem zero = with_right_side("zero matrix", solver::diagonal(std::vector<double>(n, 0.0)), b);
  expect_breakdown(trial, zero, solve(trial, zero, epsilon, 0), epsilon, 1, b);

  // diag(p, -q) with r = (1, 1) first: d'Ad = p - q > 0. By Sylvester's law of inertia the second direction
  // has d'Ad < 0.
  const double p = random.uniform(4, 6), q = random.uniform(1, 2);
  const LinearSystem indefinite =
      with_right_side("indefinite", solver::diagonal({p, -q}), {1 / (1 - p), 1 / (1 + q)});
  const double alpha = 2 / (p - q);
  expect_breakdown(trial, indefinite, solve(trial, indefinite, epsilon, 0), epsilon, 2,
                   {indefinite.b[0] + alpha, indefinite.b[1] + alpha});

  // Singular: eigenvalue 0 once, for the vector of ones.
  const int size = random.integer(6, 10);
  std::vector<solver::SparseMatrix::Entry> ring;
  for (int i = 0; i < size; ++i) {
    ring.push_back({i, i, 2});
    ring.push_back({i, (i + 1) % size, -1});
    ring.push_back({i, (i + size - 1) % size, -1});
  }
  const solver::SparseMatrix laplacian(size, size, ring);
  // Rounding decides where CG ends; but it ends, with a finite x and an honest residual.
  const LinearSystem consistent =
      sparse_system("semi-definite, consistent", laplacian, random.normals(size), 0);
  expect_honest_value(trial, consistent, solve(trial, consistent, epsilon, 0));
  LinearSystem inconsistent = with_right_side("semi-definite, inconsistent", laplacian, random.normals(size));
  double mean = 0;
  for (double value : inconsistent.b) mean += value / size;
  for (double& value : inconsistent.b) value += 1 - mean;  // a mean of 1: what no x can reach
  inconsistent.ill_conditioned = true;
  expect_honest_value(trial, inconsistent, solve(trial, inconsistent, epsilon, 0));
}

void not_finite(Trial& trial) {
  Random& random = trial.random;
  expect_solves_ordinary_system(trial);
  const int n = random.integer(8, 12);
  const LinearSystem system = spectral_system("not finite", solver::log_spaced(n, 1, 30), random);
  const double epsilon = tolerance_after(system, 6).epsilon;

  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (double value : {std::numeric_limits<double>::quiet_NaN(), kInfinity, -kInfinity}) {
    LinearSystem bad_b = system;
    bad_b.name = "b is not finite";
    bad_b.b[random.integer(0, n - 1)] = value;
    const Solution nothing = solve(trial, bad_b, epsilon, 0);
    expect_steps(trial, nothing, 0);
    trial.expect(!std::isfinite(nothing.value), "b is not finite, and yet the return value is");

    // The first product is the first residual's, product k + 1 is step k's; the 66th replaces the residual of
    // step 64.
    for (int at : {1, 2, 4, 66}) {
      LinearSystem poisoned = system;
      poisoned.name = "a product is not finite";
      poisoned.A = std::make_shared<PoisonedMatrix>(system.A, at, value);
      const Solution solution = solve(trial, poisoned, at < 66 ? epsilon : 0, 0);
      if (at == 66) continue;  // it ended; both the last x and the one before are finite
      const int steps = at - 1;
      expect_steps(trial, solution, steps);
      trial.expect(!(solution.value <= epsilon),
                   "a product is not finite, and yet the return value is at most epsilon");
      const Solution last = reference_solution(system, epsilon, steps > 1 ? steps - 1 : -1);
      // Two steps, each as in step_limit.
      const double rounding = 0x1p-53 * 16 * (system.product_error + n) * system.norm;
      trial.expect_at_most(distance(solution.x, last.x),
                           rounding * 2 * (norm(system.solution) + norm(system.b)),
                           "the error of the last finite x");
    }
  }
  where_numbers_end(trial);
}

void products(Trial& trial) {
  Random& random = trial.random;
  // epsilon = 0: it goes on to the limit.
  const LinearSystem system =
      spectral_system("products", solver::log_spaced(random.integer(150, 200), 1, 1000), random);
  for (int steps : {1, 63, 64, 65, 127, 128, 129, 200}) {
    const Solution solution = solve(trial, system, 0, steps);
    expect_steps(trial, solution, steps);
    expect_counted_products(trial, system, solution);
  }
  const auto [epsilon, steps] = tolerance_after(system, 8);
  const Solution solved = solve(trial, system, epsilon, 0);
  expect_solved(trial, system, solved, epsilon);
  expect_counted_products(trial, system, solved);
  // The second call finds b as it was.
  trial.expect(solve(trial, system, epsilon, 0, {}, 2).x == solved.x,
               "a second call with the same b gives another x");
  const LinearSystem hilbert = sparse_system("Hilbert", solver::hilbert(10), random.normals(10), 0);
  expect_counted_products(trial, hilbert, solve(trial, hilbert, 0, 0));
}

void call_after_call(Trial& trial) {
  Random& random = trial.random;
  const int n = random.integer(10, 20);
  const LinearSystem first = spectral_system("first", solver::log_spaced(n, 1, 40), random);
  const LinearSystem larger = spectral_system("second, larger", solver::log_spaced(3 * n, 1, 80), random);
  const LinearSystem smaller = spectral_system("third, smaller", solver::log_spaced(n / 2, 1, 10), random);
  const double epsilon = tolerance_after(first, 4).epsilon;
  const Solution before = solve(trial, first, epsilon, 0);
  expect_solved(trial, first, before, epsilon);
  for (const LinearSystem* other : {&larger, &smaller}) {
    const double other_epsilon = tolerance_after(*other, 3).epsilon;
    expect_solved(trial, *other, solve(trial, *other, other_epsilon, 0), other_epsilon);
    // Forty steps, and forty more: none is a 64th.
    const Solution many = solve(trial, larger, 0, 40);
    expect_steps(trial, many, 40);
    expect_counted_products(trial, larger, many);
    const Solution after = solve(trial, first, epsilon, 0);
    trial.expect(after.x == before.x && after.steps == before.steps && after.value == before.value,
                 "the same call gives another result the second time");
  }
}

}  // namespace grader::s1
