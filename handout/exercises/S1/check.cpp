// The public checks of S1. Every failure prints the input, what was expected, what came, the error and its
// bound. The contract is in solver/linearSolver.h. Grading checks the same contract on other inputs, and more
// of them.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "check.h"

using namespace checks;
using solver::diagonal;

namespace {

const double kNaN = std::numeric_limits<double>::quiet_NaN();

// All that comes out of one call of ConjGrad.
struct Outcome {
  Vector x;
  double returned;
  int steps, products;
};

Outcome solve(implicitMatrix& A, const Vector& b, double epsilon, int most_steps, double x_on_entry = 0) {
  Counted counted(A);
  Vector b_given = b;
  Outcome out{Vector(b.size(), x_on_entry), kNaN, most_steps, 0};
  out.returned =
      ConjGrad(static_cast<int>(b.size()), &counted, out.x.data(), b_given.data(), epsilon, &out.steps);
  out.products = counted.products;
  EXPECT_EQ(b_given, b) << "ConjGrad changed b";
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

void expect_solved(const System& s, const Outcome& out, double epsilon) {
  EXPECT_LE(out.returned, epsilon) << "it returned before ||b - Ax||^2 was <= epsilon";
  expect_near(
      out.x, s.solution, (std::sqrt(epsilon) + gap(s)) / s.smallest,
      "(sqrt(epsilon) + (64 (10 + 2e) + n) u ||A|| X) / smallest eigenvalue: see solver/linearSolver.h");
}

// The hair tolerance: a residual of 1e-10 ||b||.
double relative_epsilon(const Vector& b) {
  return std::pow(1e-10 * norm(b), 2);
}

// Converges too slowly to get anywhere near a residual of 0: eigenvalues from 1e-10 to 1, and no zeros in the
// matrix.
solver::SpectralMatrix slow_matrix(int n) {
  return {solver::log_spaced(n, 1e-10, 1), {Vector(n, 1.0), scattered(n)}};
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
  look_at("beta");
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
    System s = system_with("the tridiagonal (-1, 3, -1), n = " + std::to_string(n),
                           solver::tridiagonal(n, 3, -1), scattered(n), 1);
    const double epsilon = relative_epsilon(s.b);
    SCOPED_TRACE(call(s.name, epsilon, 0));
    expect_solved(s, solve(s.A, s.b, epsilon, 0), epsilon);
  }
}

TEST(Systems, SolvesAGridInMoreThan64Steps) {
  look_at("many-steps");
  System s =
      system_with("the 2-D Poisson matrix on a 20 x 20 grid", solver::poisson_2d(20), scattered(400), 0.04);
  const double epsilon = relative_epsilon(s.b);
  SCOPED_TRACE(call(s.name, epsilon, 0));
  expect_solved(s, solve(s.A, s.b, epsilon, 0), epsilon);
}

TEST(Hard, SolvesAStiffStrandOfHair) {
  const double mass = 2e-8;  // kg
  System s =
      system_with("M + h^2 K of a strand, 30 particles of 2e-8 kg",
                  solver::strand_implicit_euler(Vector(30, mass), 1000, 1e-2, 1e-4), scattered(90), mass);
  const double epsilon = relative_epsilon(s.b);
  SCOPED_TRACE(call(s.name, epsilon, 1000));
  expect_solved(s, solve(s.A, s.b, epsilon, 1000), epsilon);
}

TEST(Systems, EndsAfterAsManyStepsAsThereAreDistinctEigenvalues) {
  look_at("beta");
  Vector eigenvalues(99);
  for (std::size_t i = 0; i < eigenvalues.size(); ++i) eigenvalues[i] = Vector{0.5, 2, 5}[i % 3];
  System s = system_with("a diagonal matrix of the numbers 0.5, 2 and 5, n = 99", diagonal(eigenvalues),
                         scattered(99), 0.5);
  const double epsilon = relative_epsilon(s.b);
  SCOPED_TRACE(call(s.name, epsilon, 0));
  const Outcome out = solve(s.A, s.b, epsilon, 0);
  expect_solved(s, out, epsilon);
  EXPECT_COUNT(out.steps, 3);
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
  look_at("zero");
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
  look_at("junk");
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

TEST(Tolerance, EpsilonBoundsTheSquareOfTheNorm) {
  // From the first guess x = b the residual is b - Ab = (0, 1 - d) for b = (0, 1).
  for (auto [d, epsilon, steps] : {std::tuple{1.1, 0.05, 0}, std::tuple{11.0, 50.0, 1}}) {
    solver::SparseMatrix A = diagonal({1, d});
    std::ostringstream name;
    name << "A = [1 0; 0 " << d << "], b = (0, 1), whose first residual is r = (0, " << 1 - d << ")";
    SCOPED_TRACE(call(name.str(), epsilon, 0));
    EXPECT_COUNT(solve(A, {0, 1}, epsilon, 0).steps, steps) << "||r||^2 = " << (1 - d) * (1 - d);
  }
}

TEST(Tolerance, NeverReachesANegativeEpsilon) {
  look_at("negative");
  solver::SpectralMatrix A = slow_matrix(40);
  SCOPED_TRACE(call("eigenvalues from 1e-10 to 1, n = 40", -1e9, 3));
  EXPECT_COUNT(solve(A, scattered(40), -1e9, 3).steps, 3) << "no squared norm is negative";
}

TEST(Tolerance, MeetsATinyEpsilon) {
  look_at("tiny");
  // Scaled to a right-hand side of 1e-30, and an epsilon that is its square, times the square of a relative 1e-3.
  System s =
      system_with("the tridiagonal (-1, 3, -1), n = 30", solver::tridiagonal(30, 3, -1), scattered(30), 1);
  for (Vector* vector : {&s.b, &s.solution})
    for (double& value : *vector) value *= 1e-30;
  const double epsilon = std::pow(1e-3 * norm(s.b), 2);
  SCOPED_TRACE(call(s.name + ", b of 1e-30", epsilon, 0));
  const Outcome out = solve(s.A, s.b, epsilon, 0);
  expect_solved(s, out, epsilon);
  EXPECT_LE(out.steps, 12)
      << "this matrix takes some 6 steps for three digits: it ends as soon as epsilon is met";
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
  solver::SpectralMatrix A = slow_matrix(40);
  const Vector b = scattered(40);
  for (int most_steps : {1, 2, 17, 150}) {
    SCOPED_TRACE(call("eigenvalues from 1e-10 to 1, n = 40", 0, most_steps));
    EXPECT_COUNT(solve(A, b, 0, most_steps).steps, most_steps);
  }
}

TEST(StepLimit, TakesZeroStepsForTheDefault) {
  look_at("default");
  for (int n : {40, 60}) {
    solver::SpectralMatrix A = slow_matrix(n);
    SCOPED_TRACE(call("eigenvalues from 1e-10 to 1, n = " + std::to_string(n), 0, 0));
    EXPECT_COUNT(solve(A, scattered(n), 0, 0).steps, std::max(100, 2 * n))
        << "*steps = 0 stands for max(100, 2n)";
  }
}

TEST(StepLimit, TakesNegativeStepsForNone) {
  look_at("negative");
  solver::SparseMatrix A = diagonal({2, 1});
  SCOPED_TRACE(call("A = [2 0; 0 1], b = (1, 1)", 1e-5, -3));
  const Outcome out = solve(A, {1, 1}, 1e-5, -3);
  EXPECT_COUNT(out.steps, 0);
  EXPECT_EQ(out.x, (Vector{1, 1})) << "without a step x stays the first guess, b";
  EXPECT_NUMBER(out.returned, 1, 0) << "||b - Ab||^2 with b - Ab = (-1, 0)";
}

TEST(SixtyFourth, TakesOneProductAStepAndOneMoreEvery64) {
  solver::SpectralMatrix A = slow_matrix(40);
  for (int steps : {1, 5, 63, 64, 65, 130}) {
    SCOPED_TRACE(call("eigenvalues from 1e-10 to 1, n = 40", 0, steps));
    EXPECT_COUNT(solve(A, scattered(40), 0, steps).products, 1 + steps + steps / 64)
        << "products = 1 + steps + floor(steps / 64)";
  }
  solver::SparseMatrix three = diagonal({1.5, 3, 4});
  SCOPED_TRACE(call("A = diag(1.5, 3, 4), b = (1, 1, 1)", 1e-15, 30));
  const Outcome met = solve(three, {1, 1, 1}, 1e-15, 30);
  EXPECT_COUNT(met.products, 1 + met.steps) << "it ends as soon as epsilon is met, without another product";
}

TEST(SixtyFourth, MovesXAtEachStepToWhereTheResidualIsOrthogonalToIt) {
  look_at("order");
  // The residual falls from r to r - A s by the step s = alpha d, and what is left is orthogonal to r. So A s is
  // at least as long as r, and s as ||r|| / ||A||. Half of that leaves room for rounding.
  System s = system_with("the tridiagonal (-1, 2, -1), n = 220", solver::tridiagonal(220, 2, -1),
                         scattered(220), 2e-4);
  for (int last : {1, 63, 64, 65, 128, 192}) {
    SCOPED_TRACE("step " + std::to_string(last) + " of " + call(s.name, 0, last));
    const Vector before = solve(s.A, s.b, 0, last > 1 ? last - 1 : -1).x, x = solve(s.A, s.b, 0, last).x;
    const Vector step = difference(x, before), residual = difference(s.b, product(s.A, x));
    const double r = norm(difference(s.b, product(s.A, before)));
    EXPECT_GE(norm(step), r / s.A.norm_bound() / 2)
        << "how far x moved; bound: ||b - Ax|| / (2 ||A||), x before";
    double along = 0;
    for (std::size_t i = 0; i < step.size(); ++i) along += step[i] * residual[i];
    EXPECT_LE(std::abs(along), norm(step) * 2 * gap(s))
        << "step . (b - Ax), x after; bound: ||step|| times twice the rounding error of b - Ax, see "
           "solver/linearSolver.h";
  }
}

TEST(Hard, TakesNoMoreStepsOnALongWayThanItsDirectionsNeed) {
  look_at("restart");
  // On paper n different eigenvalues take n steps. The new residual of each 64th step is no new start: a beta of
  // 0 there forgets all directions so far. Rounding turns them a little; that costs no program a third more.
  const int n = 250;
  System s = system_with("the tridiagonal (-1, 2, -1), n = 250", solver::tridiagonal(n, 2, -1), scattered(n),
                         4 * std::pow(std::sin(std::acos(-1) / (2 * (n + 1))), 2));
  const double epsilon = std::pow(1e-8 * norm(s.b), 2);
  {
    SCOPED_TRACE(call(s.name, epsilon, 20 * n));
    const Outcome out = solve(s.A, s.b, epsilon, 20 * n);
    expect_solved(s, out, epsilon);
    EXPECT_LE(out.steps, 4 * n / 3) << "it has 250 different eigenvalues, so 250 steps would do";
  }
  // Far more steps than unknowns, for here rounding turns directions a lot: our programs take 224 to 249.
  solver::SpectralMatrix A(solver::log_spaced(40, 1, 1e6), {Vector(40, 1.0), scattered(40)});
  Vector solution = scattered(40), b(40);
  A.matVecMult(solution.data(), b.data());
  const double tolerance = std::pow(1e-8 * norm(b), 2);
  SCOPED_TRACE(call("eigenvalues from 1 to 1e6, n = 40", tolerance, 4000));
  const Outcome out = solve(A, b, tolerance, 4000);
  EXPECT_LE(out.returned, tolerance);
  EXPECT_LE(out.steps, 4 * 240 / 3) << "some 240 steps would do";
}

TEST(Scaling, ScalesWithTheRightHandSide) {
  solver::SparseMatrix A = solver::poisson_2d(5);
  const Vector b = scattered(25);
  const Outcome plain = solve(A, b, 1e-16, 0);
  for (int k : {-465, 465}) {
    SCOPED_TRACE(call("the 2-D Poisson matrix on a 5 x 5 grid, b times 2^" + std::to_string(k),
                      std::ldexp(1e-16, 2 * k), 0));
    Vector scaled_b = b, scaled_x = plain.x;
    for (double& value : scaled_b) value = std::ldexp(value, k);
    for (double& value : scaled_x) value = std::ldexp(value, k);
    const Outcome scaled = solve(A, scaled_b, std::ldexp(1e-16, 2 * k), 0);
    EXPECT_COUNT(scaled.steps, plain.steps);
    EXPECT_EQ(scaled.x, scaled_x) << "a power of two changes no digit";
  }
}

TEST(CallAfterCall, GivesTheSameAnswerWhenItIsAskedAgain) {
  solver::SparseMatrix A = solver::tridiagonal(10, 3, -1), other = solver::poisson_2d(6);
  const Outcome first = solve(A, scattered(10), 1e-20, 0);
  solve(other, scattered(36), 1e-20, 0);
  for (int i = 1; i <= kManyCalls; ++i) {
    SCOPED_TRACE(call("the tridiagonal (-1, 3, -1), n = 10, asked again after another system, " +
                          std::to_string(i) + " times so far",
                      1e-20, 0));
    const Outcome again = solve(A, scattered(10), 1e-20, 0);
    ASSERT_EQ(again.x, first.x);
    ASSERT_EQ(again.steps, first.steps);
  }
}

TEST(Sizes, SolvesTenThousandEquations) {
  const int n = 10000;
  const System s =
      system_with("the tridiagonal (-1, 3, -1), n = 10000", solver::tridiagonal(n, 3, -1), scattered(n), 1);
  const double epsilon = relative_epsilon(s.b);
  SCOPED_TRACE(call(s.name, epsilon, 0));
  solver::SparseMatrix A = s.A;
  expect_solved(s, solve(A, s.b, epsilon, 0), epsilon);
}

TEST(NotPositiveDefinite, EndsAtADirectionThatIsNotUphill) {
  struct Case {
    std::string name;
    solver::SparseMatrix A;
    Vector b;
    double returned;
  };
  // Each first residual r = b - Ab has r'Ar <= 0.
  for (Case& c :
       std::vector<Case>{{"indefinite: A = [1 0; 0 -1], b = (1, 1)", diagonal({1, -1}), {1, 1}, 4},
                         {"negative definite: A = [-1 0; 0 -2], b = (1, 1)", diagonal({-1, -2}), {1, 1}, 13},
                         {"singular: A = [1 0; 0 0], b = (1, 1)", diagonal({1, 0}), {1, 1}, 1},
                         {"zero: A = 0, b = (3, 4)", diagonal({0, 0}), {3, 4}, 25}}) {
    SCOPED_TRACE(call(c.name, 1e-5, 0));
    const Outcome out = solve(c.A, c.b, 1e-5, 0);
    EXPECT_COUNT(out.steps, 1) << "the iteration that fails counts";
    EXPECT_EQ(out.x, c.b) << "x stays the last one, which is the first guess, b";
    EXPECT_NUMBER(out.returned, c.returned, 0) << "||b - Ax||^2 of that x";
  }
}

TEST(NotPositiveDefinite, SolvesAConsistentSingularSystem) {
  look_at("singular");
  System s{"A = [2 0; 0 0], b = (1, 0)", diagonal({2, 0}), {1, 0}, {0.5, 0}, 2};
  SCOPED_TRACE(call(s.name, 1e-5, 0));
  const Outcome out = solve(s.A, s.b, 1e-5, 0);
  expect_solved(s, out, 1e-5);
  EXPECT_COUNT(out.steps, 1);
}

TEST(NotFinite, EndsAtAValueThatIsNotFinite) {
  // The fourth product, which is the third iteration's, goes wrong.
  class Broken : public implicitMatrix {
   public:
    explicit Broken(double value) : value_(value) {}
    void matVecMult(double x[], double b[]) override {
      good_.matVecMult(x, b);
      if (++products_ == 4) b[2] = value_;
    }

   private:
    solver::SparseMatrix good_ = solver::tridiagonal(10, 3, -1);
    double value_;
    int products_ = 0;
  };
  solver::SparseMatrix good = solver::tridiagonal(10, 3, -1);
  const Outcome two_steps = solve(good, scattered(10), 1e-20, 2);
  for (double value : {kNaN, std::numeric_limits<double>::infinity()}) {
    Broken A(value);
    SCOPED_TRACE(
        call("a product that gives " + in_words({value}) + " in the third iteration, n = 10", 1e-20, 0));
    const Outcome out = solve(A, scattered(10), 1e-20, 0);
    EXPECT_COUNT(out.steps, 3) << "the iteration that fails counts";
    EXPECT_EQ(out.x, two_steps.x) << "x is the last one that was finite";
    EXPECT_FALSE(out.returned <= 1e-20) << "returned " << out.returned;
  }
}

TEST(NotFinite, EndsAtATrueResidualThatIsNotFinite) {
  look_at("residual");
  // One product, one in each of 64 steps, and one for the residual that replaces the recurrence's: 66.
  class Broken : public implicitMatrix {
   public:
    void matVecMult(double x[], double b[]) override {
      good_.matVecMult(x, b);
      if (++products_ == 66) b[0] = kNaN;
    }

   private:
    solver::SpectralMatrix good_ = slow_matrix(40);
    int products_ = 0;
  } A;
  SCOPED_TRACE(call("a product that gives NaN after the 64th step, n = 40", 0, 90));
  const Outcome out = solve(A, scattered(40), 0, 90);
  for (double value : out.x) ASSERT_TRUE(std::isfinite(value)) << "x is no longer finite";
}

TEST(NotFinite, TakesNoStepFromAResidualThatIsNotFinite) {
  look_at("residual");
  // The first product is infinite in one place, and so is the first residual.
  class Broken : public implicitMatrix {
   public:
    void matVecMult(double x[], double b[]) override {
      for (int i = 0; i < 3; ++i) b[i] = 2 * x[i];
      b[1] = std::numeric_limits<double>::infinity();
    }
  } A;
  SCOPED_TRACE(call("a matrix whose products are infinite in one place, b = (1, 2, 3)", 1e-9, 20));
  const Outcome out = solve(A, {1, 2, 3}, 1e-9, 20);
  EXPECT_COUNT(out.steps, 0);
  EXPECT_EQ(out.x, (Vector{1, 2, 3})) << "without a step x stays the first guess, b";
  EXPECT_FALSE(out.returned <= 1e-9) << "returned " << out.returned;
}

TEST(NotFinite, EndsBeforeXOverflows) {
  look_at("overflow");
  // The next x is b + alpha (b - Ab), with an entry of 7e308 in the last case and more in the others: no double.
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
  // With B = b / a: after the first step x = (1.6 B, 1.6 B), to some twenty roundings; the second one would lead to (B, 4 B), and
  // 4 B = 2.4e308 is no double, though 1.6 B - 2.4 B is one.
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
  look_at("sum");
  // The residual is b to 1 part in 1e157, so one step is all, with some twenty roundings. Both entries of x are numbers; their
  // sum would be none.
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
  SCOPED_TRACE(call(s.name, 1e282, 0));
  const Outcome out = solve(s.A, s.b, 1e282, 0);
  if (out.steps > 1) {
    SCOPED_TRACE("it went on, which is right if its sums hold 4.6e311, as those of long double do");
    expect_solved(s, out, 1e282);
    return;
  }
  EXPECT_COUNT(out.steps, 1) << "the iteration that fails counts";
  EXPECT_EQ(out.x, s.b) << "x stays the last one, which is the first guess, b";
  EXPECT_FALSE(out.returned <= 1e282) << "returned " << out.returned;
}

TEST(Systems, AgreesWithTheGoldenData) {
  look_at("many-steps");
  for (Golden& golden : read_golden("S1")) {
    System& s = golden.system;
    SCOPED_TRACE(call(s.name, golden.epsilon, 0));
    const Outcome out = solve(s.A, s.b, golden.epsilon, 0);
    EXPECT_COUNT(out.steps, golden.steps);
    EXPECT_LE(out.returned, golden.epsilon);
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
