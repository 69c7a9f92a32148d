// What the normal equations cost in digits: A'A x = A'b has the square of A's condition number, and loses
// twice as many digits as a way that works on A itself. Source: Golub and Van Loan, "Matrix Computations",
// 4th edition, section 5.3.7; Higham, "Accuracy and Stability of Numerical Algorithms", 2nd edition, theorem
// 19.5 and section 20.4.
#pragma once

#include <functional>
#include <vector>

#include "solver/linearSolver.h"
#include "solver/study/history.h"

namespace solver::study {

// As solve_normal_equations in solver/normal_equations.h.
using NormalEquationsFunction =
    std::function<double(int rows, int cols, implicitMatrix* A, implicitMatrix* A_transposed, double x[],
                         double b[], double epsilon, int* steps)>;

inline constexpr double kRounding = 1.1102230246251565e-16;  // u = 2^-53

// Relative errors ||x - x*|| / ||x*||; not a number where a method found no solution.
struct DigitsLost {
  double condition = 1;
  double conj_grad = 0;  // on A'A, by the function that is studied
  int iterations = 0;    // that it took
  bool stopped = false;  // after all that it was given: no end, so that digits say nothing
  double cholesky = 0;   // of A'A as a table (Eigen's LLT)
  double qr = 0;         // of A: Householder (Eigen)
  double pivoted_qr = 0;
};

inline constexpr int kDigitsUnknowns = 40;

// A is 40 x 40 and not symmetric, with singular values from 1/condition to 1, their logarithms evenly spaced;
// the errors are the medians of `draws` matrices and solutions. The normal equations end where rounding ends
// them, or after most_iterations.
DigitsLost digits_lost(const NormalEquationsFunction& solve, double condition, int draws,
                       int most_iterations);

}  // namespace solver::study
