// The public checks of S1. Every failure prints the input, the expected and the actual value, the error and
// its bound. The contract is in solver/linearSolver.h. Grading checks the same contract with more and other
// inputs.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "check.h"
#include "ordinary.h"

using namespace checks;
using solver::diagonal;

namespace {

const double kNaN = std::numeric_limits<double>::quiet_NaN();

// Values for checks that are about something else: a residual of 1e-3 if ||b|| = 1, and more than enough
// steps.
constexpr double kEpsilon = 1e-6;
constexpr int kEnough = 1000;

// All that comes out of one call of ConjGrad.
struct Outcome {
  Vector x;
  double returned;
  int steps, products;
  Vector b;  // as ConjGrad left it
};

Outcome solve(implicitMatrix& A, const Vector& b, double epsilon, int most_steps, double x_on_entry = 0) {
  Counted counted(A);
  Outcome out{Vector(b.size(), x_on_entry), kNaN, most_steps, 0, b};
  out.returned =
      ConjGrad(static_cast<int>(b.size()), &counted, out.x.data(), out.b.data(), epsilon, &out.steps);
  out.products = counted.products;
  return out;
}

std::string call(const std::string& name, double epsilon, int most_steps) {
  std::ostringstream text;
  text << "ConjGrad with " << name << ", epsilon = " << epsilon << ", *steps = " << most_steps;
  return text.str();
}

double gap(const System& s) {
  return residual_gap(s.A.norm_bound(), s.A.longest_row(), s.solution, s.b);
}

// Ax = b with a known solution.
System system_with(const std::string& name, solver::SparseMatrix A, const Vector& solution, double smallest) {
  Vector b = product(A, solution);
  return {name, std::move(A), b, solution, smallest};
}

double residual(const System& s, const Vector& x) {
  solver::SparseMatrix A = s.A;
  return norm(difference(s.b, product(A, x)));
}

void expect_solved(const System& s, const Outcome& out, double epsilon) {
  const double bound = std::sqrt(epsilon) + gap(s);
  if (residual(s, out.x) > bound && out.steps == 0)
    note_hint(out.x == s.b ? "x is still b: which test ends the loop before x moves, and is its r^T r right?"
                           : "no step was counted, and x is not b: which return comes before x = b?");
  else if (residual(s, out.x) > bound && out.x == s.b)
    note_hint("steps were counted, and x is still b: is x += alpha d there?");
  EXPECT_LE(residual(s, out.x), bound)
      << "||b - Ax||; bound: sqrt(epsilon) and rounding, see solver/linearSolver.h\nx = " << in_words(out.x)
      << " after " << out.steps << " steps, returned " << out.returned;
  expect_near(out.x, s.solution, bound / s.smallest, "that of ||b - Ax|| / smallest eigenvalue");
}

// A and b scaled so that ||b|| = ||b - Ab|| = 1, for checks that are not about epsilon.
System even(System s) {
  const double c = solver::even_scale(s.A, s.b), length = norm(s.b);
  s.A = scaled(s.A, c);
  for (double& value : s.b) value /= length;
  for (double& value : s.solution) value /= c * length;
  s.smallest *= c;
  s.name += ", scaled to ||b|| = ||b - Ab|| = 1";
  return s;
}

// With epsilon = 0 and a large b only the step limit ends the call. Then ||b - Ax|| is at most `tolerance`
// ||b||.
void expect_goes_on(System s, int most_steps, double tolerance) {
  const double scale = 0x1p50 / norm(s.b);
  for (double& value : s.b) value *= scale;
  SCOPED_TRACE(call(s.name + ", scaled to ||b|| = 2^50", 0, most_steps));
  const Outcome out = solve(s.A, s.b, 0, most_steps);
  // A loop that ends early takes one product more or less.
  if (residual(s, out.x) / 0x1p50 > tolerance &&
      std::abs(out.products - (1 + out.steps + out.steps / 64)) > 1)
    note_hint(
        "1 + steps + steps / 64 products are due: is r = b - Ax computed at each 64th step, and nowhere "
        "else?");
  EXPECT_LE(residual(s, out.x) / 0x1p50, tolerance)
      << "||b - Ax|| / ||b|| after " << out.steps << " steps, with " << out.products << " products";
  if (residual(s, out.x) > residual_gap(s.A.norm_bound(), s.A.longest_row(), out.x, s.b)) {
    EXPECT_GE(out.products, 1 + most_steps)
        << "products: it ends before the limit, and ||b - Ax||^2 is not 0";
  }
}

// A matrix without zeros, with eigenvalues from 1e-10 to 1. ConjGrad converges on it so slowly that the
// residual stays far from 0.
solver::SpectralMatrix slow_matrix(int n) {
  return {solver::log_spaced(n, 1e-10, 1), {Vector(n, 1.0), scattered(n)}};
}

solver::SparseMatrix table_of(solver::SpectralMatrix& A) {
  std::vector<solver::SparseMatrix::Entry> entries;
  for (int j = 0; j < A.size(); ++j) {
    Vector unit(A.size(), 0.0), column(A.size());
    unit[j] = 1;
    A.matVecMult(unit.data(), column.data());
    for (int i = 0; i < A.size(); ++i) entries.push_back({i, j, column[i]});
  }
  return {A.size(), A.size(), entries};
}

// Each residual of ConjGrad is `ratios[k]` times as long as the one before; then it is 0.
System planned(const std::string& name, const Vector& ratios) {
  const int n = static_cast<int>(ratios.size()) + 1;
  Scatter scatter(n);
  const double scale = ordinary_number(scatter, 0.6, 1.9);
  Vector curvatures(n);
  for (double& value : curvatures) value = scale * scatter.uniform(1, 1.1);
  const solver::PlannedSystem system = solver::planned_system(curvatures, ratios, scattered(n));
  return {name + ", n = " + std::to_string(n), system.A, system.b, Vector(n, 0.0), 0};
}

// The residual falls by 4 to 12 percent in each of the first 135 steps.
System falling() {
  Vector ratios(134);
  Scatter scatter(0);
  for (double& ratio : ratios) ratio = scatter.uniform(0.88, 0.96);
  System s = planned("a matrix that needs 135 steps, b of 2^50", ratios);
  for (double& value : s.b) value *= 0x1p50;
  return s;
}

}  // namespace

TEST(Systems, SolvesExample1OfTheLectureInOneStep) {
  System s{"A = [2 0; 0 1], b = (1, 1)", diagonal({2, 1}), {1, 1}, {0.5, 1}, 1};
  SCOPED_TRACE(call(s.name, 1e-5, 100));
  const Outcome out = solve(s.A, s.b, 1e-5, 100);
  expect_solved(s, out, 1e-5);
  EXPECT_COUNT(out.steps, 1) << (out.steps == 2
                                     ? "hint       = one step too many: a count, or a start that is not b?"
                                     : "");
}

TEST(Systems, SolvesExample2OfTheLectureInTwoSteps) {
  System s{"A = [2 1; 1 1], b = (3, 4)",
           solver::SparseMatrix(2, 2, {{0, 0, 2}, {0, 1, 1}, {1, 0, 1}, {1, 1, 1}}),
           {3, 4},
           {-1, 5},
           0.38};
  SCOPED_TRACE(call(s.name, 1e-5, 100));
  const Outcome out = solve(s.A, s.b, 1e-5, 100);
  expect_solved(s, out, 1e-5);
  EXPECT_COUNT(out.steps, 2);
}

TEST(Sizes, SolvesSystemsOfManySizes) {
  for (int n : {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 100, 1000, 5000}) {
    System s = even(system_with("the tridiagonal (-1, 3, -1), n = " + std::to_string(n),
                                solver::tridiagonal(n, 3, -1), scattered(n), 1));
    SCOPED_TRACE(call(s.name, kEpsilon, kEnough));
    expect_solved(s, solve(s.A, s.b, kEpsilon, kEnough), kEpsilon);
  }
}

TEST(Systems, SolvesAGrid) {
  System s = even(
      system_with("the 2-D Poisson matrix on a 12 x 12 grid", solver::poisson_2d(12), scattered(144), 0.1));
  SCOPED_TRACE(call(s.name, kEpsilon, 60));
  expect_solved(s, solve(s.A, s.b, kEpsilon, 60), kEpsilon);
}

TEST(Hard, GoesOnWhereTheResidualDoesNotFall) {
  expect_goes_on(planned("a residual that stays as long in one step", {0.7, 0.5, 1, 0.6, 0.8}), 8, 1e-6);
  expect_goes_on(planned("a residual that stays as long in 14 steps", Vector(14, 1.0)), 17, 1e-6);
  expect_goes_on(
      planned("a residual that grows in 4 steps, and falls then", {1.9, 1.2, 1.7, 1.4, 0.6, 0.3, 0.7}), 10,
      1e-6);
}

TEST(Hard, SolvesAStiffStrandOfHair) {
  Scatter scatter(1);
  Vector masses(30);
  for (double& mass : masses) mass = 1e-8 * ordinary_number(scatter, 0.8, 4);  // kg
  expect_goes_on(system_with("M + h^2 K of a strand, 30 particles of 0.8e-8 to 4e-8 kg",
                             solver::strand_implicit_euler(masses, 1000, 1e-2, 1e-4), scattered(90), 0.8e-8),
                 1000, 1e-9);
}

TEST(Systems, EndsAfterAsManyStepsAsThereAreDistinctEigenvalues) {
  Vector eigenvalues(99);
  for (std::size_t i = 0; i < eigenvalues.size(); ++i) eigenvalues[i] = Vector{0.5, 2, 5}[i % 3];
  System s = even(system_with("a diagonal matrix of the numbers 0.5, 2 and 5, n = 99", diagonal(eigenvalues),
                              scattered(99), 0.5));
  SCOPED_TRACE(call(s.name, kEpsilon, 50));
  const Outcome out = solve(s.A, s.b, kEpsilon, 50);
  expect_solved(s, out, kEpsilon);
  EXPECT_COUNT(out.steps, 3);
  expect_goes_on(s, 3, 1e-9);
}

TEST(FirstGuess, TakesNoStepWhereTheFirstGuessIsRight) {
  solver::SparseMatrix identity = diagonal(Vector(5, 1.0));
  const Vector b = scattered(5);
  SCOPED_TRACE(call("the identity, n = 5", 1e-5, 0));
  const Outcome out = solve(identity, b, 1e-5, 0);
  EXPECT_COUNT(out.steps, 0) << "the first guess is x = b";
  EXPECT_EQ(out.x, b);
  EXPECT_NUMBER(out.returned, 0, 0);
}

TEST(FirstGuess, SolvesForZeroInNoSteps) {
  solver::SparseMatrix A = solver::tridiagonal(4, 3, -1);
  SCOPED_TRACE(call("the tridiagonal (-1, 3, -1), b = 0", 0, 9));
  const Outcome out = solve(A, Vector(4, 0.0), 0, 9);
  EXPECT_COUNT(out.steps, 0);
  EXPECT_EQ(out.x, Vector(4, 0.0));
  EXPECT_NUMBER(out.returned, 0, 0);
}

TEST(Empty, SolvesTheEmptySystem) {
  solver::SparseMatrix A = diagonal({});
  for (double epsilon : {1e-5, 0.0, -1e-5}) {
    SCOPED_TRACE(call("n = 0", epsilon, 7));
    const Outcome out = solve(A, {}, epsilon, 7);
    EXPECT_COUNT(out.steps, 0) << "where there is nothing to solve, no step is taken, whatever epsilon is";
    EXPECT_NUMBER(out.returned, 0, 0);
  }
}

TEST(FirstGuess, OnlyWritesX) {
  solver::SparseMatrix A = solver::tridiagonal(10, 3, -1);
  const Vector b = scattered(10);
  const Outcome from_zeros = solve(A, b, 1e-20, 0, 0);
  for (double junk : {1.0, -1e300, kNaN}) {
    SCOPED_TRACE(call("the tridiagonal (-1, 3, -1), n = 10, x = " + in_words({junk}) + " everywhere on entry",
                      1e-20, 0));
    const Outcome out = solve(A, b, 1e-20, 0, junk);
    EXPECT_EQ(out.x, from_zeros.x) << "what the caller left in x must not matter: the first guess is x = b";
    EXPECT_COUNT(out.steps, from_zeros.steps);
  }
}

// If epsilon lies between the squared residuals of the third and of the fourth step, the fourth one meets it.
void expect_four_steps(double scale) {
  System s = even(
      system_with("the tridiagonal (-1, 3, -1), n = 30", solver::tridiagonal(30, 3, -1), scattered(30), 1));
  for (double& value : s.b) value *= scale;
  const double third = residual(s, solve(s.A, s.b, 0, 3).x), fourth = residual(s, solve(s.A, s.b, 0, 4).x);
  EXPECT_LT(fourth, third) << "||b - Ax|| after four steps, and after three, for b times " << scale
                           << " and epsilon = 0";
  const double epsilon = third * fourth;
  SCOPED_TRACE(call(s.name + ", b times " + in_words({scale}), epsilon, 50));
  EXPECT_NUMBER(residual(s, solve(s.A, s.b, epsilon, 50).x), fourth, 0)
      << "||b - Ax||; it is " << third
      << " after three steps, so that the fourth one is the first that meets epsilon";
}

TEST(Tolerance, EpsilonBoundsTheSquareOfTheNorm) {
  expect_four_steps(1);
}

TEST(Tolerance, EpsilonIsAbsolute) {
  for (double scale : {1e6, 1e-6, 1e-30}) expect_four_steps(scale);
}

TEST(Tolerance, NeverReachesANegativeEpsilon) {
  System s = falling();
  SCOPED_TRACE(call(s.name, -1e100, 3));
  EXPECT_EQ(solve(s.A, s.b, -1e100, 3).x, solve(s.A, s.b, 0, 3).x)
      << "x, and x of epsilon = 0: no squared norm is below 0";
}

TEST(ReturnValue, ReturnsTheSquareOfTheResidualsNorm) {
  System s =
      system_with("the 2-D Poisson matrix on a 12 x 12 grid", solver::poisson_2d(12), scattered(144), 0.1);
  for (int most_steps : {-1, 1, 5, 20}) {
    SCOPED_TRACE(call(s.name, 0, most_steps));
    const Outcome out = solve(s.A, s.b, 0, most_steps);
    const double residual = norm(difference(s.b, product(s.A, out.x)));
    EXPECT_LE(std::abs(std::sqrt(out.returned) - residual), gap(s))
        << "returned " << out.returned << "; ||b - Ax||^2 = " << residual * residual
        << "; bound: (64 (10 + 2e) + n) u ||A|| X on the roots' difference, see solver/linearSolver.h";
  }
}

TEST(StepLimit, TakesAtMostTheStepsThatItMay) {
  System s = falling();
  for (int most_steps : {1, 2, 17, 120}) {
    SCOPED_TRACE(call(s.name, 0, most_steps));
    EXPECT_COUNT(solve(s.A, s.b, 0, most_steps).steps, most_steps);
  }
}

TEST(StepLimit, ReturnsTheLastXAndNotTheBest) {
  System s = planned("a residual that grows in the first step", {1.9, 1.6, 0.7, 0.4});
  SCOPED_TRACE(call(s.name, 0, 1));
  EXPECT_NUMBER(residual(s, solve(s.A, s.b, 0, 1).x) / residual(s, s.b), 1.9, 1e-9)
      << "||b - Ax|| / ||b - Ab||, x after one step; bound: rounding, times a thousand";
}

TEST(StepLimit, TakesZeroStepsForTheDefault) {
  for (int n : {40, 60}) {
    solver::SpectralMatrix A = slow_matrix(n);
    SCOPED_TRACE(call("eigenvalues from 1e-10 to 1, n = " + std::to_string(n), 0, 0));
    EXPECT_COUNT(solve(A, scattered(n), 0, 0).steps, std::max(100, 2 * n))
        << "*steps = 0 stands for max(100, 2n)";
  }
}

TEST(StepLimit, TakesNegativeStepsForNone) {
  solver::SparseMatrix A = diagonal({2, 1});
  SCOPED_TRACE(call("A = [2 0; 0 1], b = (1, 1)", 1e-5, -3));
  const Outcome out = solve(A, {1, 1}, 1e-5, -3);
  EXPECT_COUNT(out.steps, 0);
  EXPECT_EQ(out.x, (Vector{1, 1})) << "without a step x stays the first guess, b";
}

TEST(SixtyFourth, TakesOneProductAStepAndOneMoreEvery64) {
  System s = falling();
  for (int steps : {1, 5, 63, 64, 65, 130}) {
    SCOPED_TRACE(call(s.name, 0, steps));
    EXPECT_COUNT(solve(s.A, s.b, 0, steps).products, 1 + steps + steps / 64)
        << "products = 1 + steps + floor(steps / 64)";
  }
  solver::SparseMatrix three = diagonal({1.5, 3, 4});
  SCOPED_TRACE(call("A = diag(1.5, 3, 4), b = (1, 1, 1)", 1e-15, 30));
  const Outcome met = solve(three, {1, 1, 1}, 1e-15, 30);
  EXPECT_COUNT(met.products, 1 + met.steps) << "it ends as soon as epsilon is met, without another product";
}

TEST(SixtyFourth, MovesXAtEachStepToWhereTheResidualIsOrthogonalToIt) {
  // The step s = alpha d makes the residual r - A s, which is orthogonal to r. So A s is at least as long as
  // r, and s is at least ||r|| / ||A|| long. Half of that leaves room for rounding.
  System s = falling();
  for (int last : {1, 63, 64, 65, 128}) {
    SCOPED_TRACE("step " + std::to_string(last) + " of " + call(s.name, 0, last));
    const Vector before = solve(s.A, s.b, 0, last > 1 ? last - 1 : -1).x, x = solve(s.A, s.b, 0, last).x;
    const Vector step = difference(x, before), r = difference(s.b, product(s.A, x));
    EXPECT_GE(norm(step), residual(s, before) / s.A.norm_bound() / 2)
        << "how far x moved; bound: ||b - Ax|| / (2 ||A||), x before";
    double along = 0;
    for (std::size_t i = 0; i < step.size(); ++i) along += step[i] * r[i];
    EXPECT_LE(std::abs(along), norm(step) * 2 * residual_gap(s.A.norm_bound(), s.A.longest_row(), x, s.b))
        << "step . (b - Ax), x after; bound: ||step|| times twice the rounding error of b - Ax, see "
           "solver/linearSolver.h";
  }
}

TEST(Hard, TakesNoMoreStepsOnALongWayThanItsDirectionsNeed) {
  // On paper n different eigenvalues take n steps. The new residual of each 64th step is no new start: with a
  // beta of 0 there all earlier directions are forgotten. Rounding turns directions a little; that costs a
  // right program less than a third more.
  const int n = 250;
  expect_goes_on(
      system_with("the tridiagonal (-1, 2, -1), n = 250, whose 250 different eigenvalues take 250 steps",
                  solver::tridiagonal(n, 2, -1), scattered(n), 0),
      4 * n / 3, 1e-8);
  // Far more steps than unknowns, for here rounding turns directions a lot: our programs take 224 to 249.
  solver::SpectralMatrix A(solver::log_spaced(40, 1, 1e6), {Vector(40, 1.0), scattered(40)});
  expect_goes_on(system_with("eigenvalues from 1 to 1e6, n = 40, which takes some 240 steps", table_of(A),
                             scattered(40), 0),
                 4 * 240 / 3, 1e-8);
}

TEST(Scaling, ScalesWithTheRightHandSide) {
  solver::SparseMatrix A = solver::poisson_2d(5);
  const Vector b = scattered(25);
  const Outcome plain = solve(A, b, kEpsilon, kEnough);
  for (int k : {-465, 465}) {
    SCOPED_TRACE(call("the 2-D Poisson matrix on a 5 x 5 grid, b times 2^" + std::to_string(k),
                      std::ldexp(kEpsilon, 2 * k), kEnough));
    Vector scaled_b = b, scaled_x = plain.x;
    for (double& value : scaled_b) value = std::ldexp(value, k);
    for (double& value : scaled_x) value = std::ldexp(value, k);
    const Outcome scaled = solve(A, scaled_b, std::ldexp(kEpsilon, 2 * k), kEnough);
    EXPECT_COUNT(scaled.steps, plain.steps);
    EXPECT_EQ(scaled.x, scaled_x) << "a power of two changes no digit";
  }
}

TEST(CallAfterCall, GivesTheSameAnswerWhenItIsAskedAgain) {
  solver::SparseMatrix A = solver::tridiagonal(10, 3, -1), other = solver::poisson_2d(6);
  const Outcome first = solve(A, scattered(10), kEpsilon, kEnough);
  EXPECT_EQ(first.b, scattered(10)) << "ConjGrad changed b";
  solve(other, scattered(36), kEpsilon, kEnough);
  for (int i = 1; i <= kManyCalls; ++i) {
    SCOPED_TRACE(call("the tridiagonal (-1, 3, -1), n = 10, asked again after another system, " +
                          std::to_string(i) + " times so far",
                      kEpsilon, kEnough));
    const Outcome again = solve(A, scattered(10), kEpsilon, kEnough);
    ASSERT_EQ(again.x, first.x);
    ASSERT_EQ(again.steps, first.steps);
  }
}

TEST(Sizes, SolvesTenThousandEquations) {
  const int n = 10000;
  System s = even(
      system_with("the tridiagonal (-1, 3, -1), n = 10000", solver::tridiagonal(n, 3, -1), scattered(n), 1));
  SCOPED_TRACE(call(s.name, kEpsilon, kEnough));
  expect_solved(s, solve(s.A, s.b, kEpsilon, kEnough), kEpsilon);
}

TEST(NotPositiveDefinite, EndsAtADirectionThatIsNotUphill) {
  struct Case {
    std::string name;
    solver::SparseMatrix A;
    Vector b;
  };
  // Each first residual r = b - Ab has r'Ar <= 0.
  for (Case& c :
       std::vector<Case>{{"indefinite: A = [1 0; 0 -1], b = (1, 1)", diagonal({1, -1}), {1, 1}},
                         {"negative definite: A = [-1 0; 0 -2], b = (1, 1)", diagonal({-1, -2}), {1, 1}},
                         {"singular: A = [1 0; 0 0], b = (1, 1)", diagonal({1, 0}), {1, 1}},
                         {"zero: A = 0, b = (3, 4)", diagonal({0, 0}), {3, 4}}}) {
    SCOPED_TRACE(call(c.name, 1e-5, 0));
    const Outcome out = solve(c.A, c.b, 1e-5, 0);
    EXPECT_COUNT(out.steps, 1) << "the iteration that fails counts";
    EXPECT_EQ(out.x, c.b) << "x stays the last one, which is the first guess, b";
    EXPECT_FALSE(out.returned <= 1e-5) << "returned " << out.returned;
  }
}

TEST(NotPositiveDefinite, SolvesAConsistentSingularSystem) {
  System s{"A = [2 0; 0 0], b = (1, 0)", diagonal({2, 0}), {1, 0}, {0.5, 0}, 2};
  SCOPED_TRACE(call(s.name, 1e-5, 0));
  const Outcome out = solve(s.A, s.b, 1e-5, 0);
  expect_solved(s, out, 1e-5);
  EXPECT_COUNT(out.steps, 1);
}

namespace {

// Passes products on; one of them, or each if `which` is 0, gets this value in the entry `at`.
class Broken : public implicitMatrix {
 public:
  Broken(implicitMatrix& good, int which, int at, double value)
      : good_(good), which_(which), at_(at), value_(value) {}

  void matVecMult(double x[], double b[]) override {
    good_.matVecMult(x, b);
    if (++products_ == which_ || which_ == 0) b[at_] = value_;
  }

 private:
  implicitMatrix& good_;
  int which_, at_;
  double value_;
  int products_ = 0;
};

}  // namespace

TEST(NotFinite, EndsAtAValueThatIsNotFinite) {
  solver::SparseMatrix good = solver::tridiagonal(10, 3, -1);
  const Outcome two_steps = solve(good, scattered(10), 1e-20, 2);
  for (double value : {kNaN, std::numeric_limits<double>::infinity()}) {
    Broken A(good, 4, 2, value);  // the third iteration's product
    SCOPED_TRACE(
        call("a product that gives " + in_words({value}) + " in the third iteration, n = 10", 1e-20, 0));
    const Outcome out = solve(A, scattered(10), 1e-20, 0);
    EXPECT_COUNT(out.steps, 3) << "the iteration that fails counts";
    EXPECT_EQ(out.x, two_steps.x) << "x is the last one that was finite";
    EXPECT_FALSE(out.returned <= 1e-20) << "returned " << out.returned;
  }
}

TEST(NotFinite, EndsAtATrueResidualThatIsNotFinite) {
  // 66 products: one at first, one in each of 64 steps, and one for the residual that is computed anew.
  solver::SpectralMatrix good = slow_matrix(40);
  Broken A(good, 66, 0, kNaN);
  SCOPED_TRACE(call("a product that gives NaN after the 64th step, n = 40", 0, 90));
  const Outcome out = solve(A, scattered(40), 0, 90);
  for (double value : out.x) ASSERT_TRUE(std::isfinite(value)) << "x is no longer finite";
}

TEST(NotFinite, TakesNoStepFromAResidualThatIsNotFinite) {
  // The first product is infinite in one place, and so is the first residual.
  solver::SparseMatrix good = diagonal({2, 2, 2});
  Broken A(good, 0, 1, std::numeric_limits<double>::infinity());
  SCOPED_TRACE(call("a matrix whose products are infinite in one place, b = (1, 2, 3)", 1e-9, 20));
  const Outcome out = solve(A, {1, 2, 3}, 1e-9, 20);
  EXPECT_COUNT(out.steps, 0);
  EXPECT_EQ(out.x, (Vector{1, 2, 3})) << "without a step x stays the first guess, b";
  EXPECT_FALSE(out.returned <= 1e-9) << "returned " << out.returned;
}

TEST(NotFinite, EndsBeforeXOverflows) {
  // The next x is b + alpha (b - Ab), with an entry of 7e308 in the last case and more in the others: no
  // double.
  for (auto [name, d, b] : {std::tuple{"A = [1e-190 0; 0 1e-190], b = (1e140, 2e140)", Vector{1e-190, 1e-190},
                                       Vector{1e140, 2e140}},
                            {"A = [1e-190 0; 0 3], b = (1e140, 2)", {1e-190, 3}, {1e140, 2}},
                            {"A = [2 0; 0 1e-189], b = (5, 1e140)", {2, 1e-189}, {5, 1e140}},
                            {"A = [3e-309 0; 0 3e-309], b = (2, 1)", {3e-309, 3e-309}, {2, 1}}}) {
    SCOPED_TRACE(call(name, 1e-9, 0));
    solver::SparseMatrix A = diagonal(d);
    const Outcome out = solve(A, b, 1e-9, 0);
    EXPECT_COUNT(out.steps, 1) << "the iteration that fails counts";
    EXPECT_EQ(out.x, b) << "x is the last one that was finite: the first guess, b";
    EXPECT_FALSE(out.returned <= 1e-9) << "returned " << out.returned;
  }
  // With B = b / a, x is (1.6 B, 1.6 B) after the first step, to some twenty roundings. The second one would
  // lead to (B, 4 B), and 4 B = 2.4e308 is no double, though 1.6 B - 2.4 B is one.
  const double b = 2e140, B = 6e307;
  const std::string name = "A = [a 0; 0 a/4], a = 3.3e-168, b = (2e140, 2e140)";
  SCOPED_TRACE(call(name, 1e-9, 0));
  solver::SparseMatrix A = diagonal({b / B, b / B / 4});
  const Outcome out = solve(A, {b, b}, 1e-9, 0);
  EXPECT_COUNT(out.steps, 2) << "the second iteration fails, and counts";
  for (int i : {0, 1})
    EXPECT_LE(std::abs(out.x[i] / (1.6 * B) - 1), 64 * 0x1p-53)
        << "x[" << i << "] = " << out.x[i] << "; x is the last one that was finite; bound: 64 u of 9.6e307";
}

TEST(Scaling, SolvesForAnXNearTheEndOfTheNumbers) {
  // The residual is b to 1 part in 1e157, so one step is all, with some twenty roundings. Both entries of x
  // are numbers; their sum would be none.
  solver::SparseMatrix A = diagonal({2e-157, 2e-157});
  SCOPED_TRACE(call("A = [2e-157 0; 0 2e-157], b = (3e151, 2e151)", 1e282, 0));
  const Outcome out = solve(A, {3e151, 2e151}, 1e282, 0);
  EXPECT_COUNT(out.steps, 1);
  for (int i : {0, 1})
    EXPECT_LE(std::abs(out.x[i] / Vector{1.5e308, 1e308}[i] - 1), 64 * 0x1p-53)
        << "x[" << i << "] = " << out.x[i] << "; bound on the relative error: 64 u";
}

TEST(NotFinite, EndsIfTheCurvatureOverflows) {
  // r = b - Ab = -(9e150, 6e150): r'r = 1.2e302, but r'Ar = 4.6e311, more than any double.
  System s{"A = [3e9 0; 0 6e9], b = (3e141, 1e141)",
           diagonal({3e9, 6e9}),
           {3e141, 1e141},
           {1e132, 1e141 / 6e9},
           3e9};
  SCOPED_TRACE(call(s.name, 1e-9, 0));
  const Outcome out = solve(s.A, s.b, 1e-9, 0);
  if (out.steps > 1) {
    SCOPED_TRACE("it went on, which is right if its sums hold 4.6e311, as those of long double do");
    expect_solved(s, out, 1e282);
    return;
  }
  EXPECT_COUNT(out.steps, 1) << "the iteration that fails counts";
  EXPECT_EQ(out.x, s.b) << "x stays the last one, which is the first guess, b";
  EXPECT_FALSE(out.returned <= 1e-9) << "returned " << out.returned;
}

TEST(Systems, AgreesWithTheGoldenData) {
  for (Golden& golden : read_golden("S1")) {
    System& s = golden.system;
    SCOPED_TRACE(call(s.name, golden.epsilon, kEnough));
    const Outcome out = solve(s.A, s.b, golden.epsilon, kEnough);
    EXPECT_LE(out.steps, 5 * golden.steps / 2 + 5) << golden.steps << " steps would do";
    expect_near(
        out.x, s.solution, 2 * (std::sqrt(golden.epsilon) + gap(s)) / s.smallest,
        "2 (sqrt(epsilon) + (64 (10 + 2e) + n) u ||A|| X) / smallest eigenvalue, for either x may be off "
        "by half of it");
  }
}

int main(int argc, char** argv) {
  return run(argc, argv, {{"ConjGrad", [] {
                             solver::SparseMatrix empty = diagonal({});
                             double none = 0;
                             int steps = 0;
                             ConjGrad(0, &empty, &none, &none, 1, &steps);
                           }}});
}
