// The public checks share this: a matrix that counts its products, vectors in words, comparisons that print
// an error with its bound, the data in golden/, and a main program that names the functions that are not
// written yet and reports the first failure.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "digest.h"
#include "solver/matrices.h"

namespace checks {

using Vector = std::vector<double>;

// The checks repeat a call so often, since a run of a few seconds calls each function hundreds of times, and
// no function may keep anything from call to call.
inline constexpr int kManyCalls = 1000;

// Passes products on to another matrix and counts them.
class Counted : public implicitMatrix {
 public:
  explicit Counted(implicitMatrix& matrix) : matrix_(matrix) {}

  void matVecMult(double x[], double b[]) override {
    ++products;
    matrix_.matVecMult(x, b);
  }

  int products = 0;

 private:
  implicitMatrix& matrix_;
};

// A linear system Ax = b with its solution.
struct System {
  std::string name;  // for failures: "A = [2 0; 0 1], b = (1, 1)"
  solver::SparseMatrix A;
  Vector b;
  Vector solution;
  double smallest;  // at most the smallest eigenvalue of A, or of A'A if that is solved
};

Vector product(solver::SparseMatrix& A, Vector x);
Vector difference(const Vector& x, const Vector& y);
double norm(const Vector& x);

// n numbers between -1 and 1 without a pattern, the same ones every time.
Vector scattered(int n);

// "(1, 2, 3)"; of a long vector the first six values.
std::string in_words(const Vector& x);

// How far the square root of ConjGrad's return value may be from the true ||b - Ax||, by
// solver/linearSolver.h: (64 (10 + 2e) + n) u ||A|| X, with X = 2||x*|| + ||b||, and e the rounding error of
// one product over u = 2^-53: no residual is longer than ||A|| X, and adding its n squares up rounds it by n
// u at most.
double residual_gap(double norm_of_A, double e, const Vector& solution, const Vector& b);

// Keeps a hint for the failure that follows (hint.h), if the numbers show one. The first of a check counts.
void note_hint(std::span<const double> actual, std::span<const double> expected, double bound, int block = 1,
               std::span<const double> before = {});
void note_hint(const std::string& hint);

// Compare a number, within a bound, and a count of steps, products or calls. Both keep a hint from the value.
#define EXPECT_NUMBER(actual, expected, bound) EXPECT_PRED_FORMAT3(::checks::is_near, actual, expected, bound)
#define EXPECT_COUNT(actual, expected) EXPECT_PRED_FORMAT2(::checks::counts, actual, expected)
testing::AssertionResult is_near(const char* words, const char* expected_words, const char* bound_words,
                                 double actual, double expected, double bound);
testing::AssertionResult counts(const char* words, const char* expected_words, long actual, long expected);

// Fails, with all that is needed to understand it, unless ||x - solution|| <= bound.
void expect_near(const Vector& x, const Vector& solution, double bound, const std::string& source_of_bound);

// One of the cases in golden/<exercise>.txt. Its files are golden/<name>.mtx (the matrix), <name>.b.mtx and
// <name>.x.mtx.
struct Golden {
  System system;
  double epsilon;  // far from every iterate's squared residual: rounding can't change the number of steps
  int steps;
};

// Throws std::runtime_error if a file is missing.
std::vector<Golden> read_golden(const std::string& exercise);

// A function of the exercise, and a call of it that any version survives. The checks of the categories that
// ask it wait until those of the functions in `needs` pass, since they ask with these.
struct Function {
  std::string name;
  std::function<void()> call;
  std::vector<std::string> needs = {};
};

// Runs the tests, whose suites are named as the categories' ids. If a function is not implemented it says so
// in one line, and fails; the categories that ask it wait. Each suite runs in a process of its own (apart.h),
// and digest.h reports what they found. With any of GoogleTest's own options (--gtest_filter=...) this is a
// plain GoogleTest program, for a debugger.
//
//   --full      reports all failures, each whole
//   --tell      ends with 0 even after failures, so that the build tool adds nothing to the target check-X
//
// HAIR_RESULT names a file for the numbers of checks and failures; HAIR_SHOW is the command that shows the
// exercise at work.
int run_checks(int argc, char** argv, const std::string& exercise, const std::vector<Category>& categories,
               const std::vector<Function>& functions);

#ifdef HAIR_CATEGORIES
inline int run(int argc, char** argv, const std::vector<Function>& functions) {
  return run_checks(argc, argv, HAIR_EXERCISE_ID,
                    {
#include HAIR_CATEGORIES
                    },
                    functions);
}
#endif

}  // namespace checks
