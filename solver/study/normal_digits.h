// Measures the digits that the normal equations lose: A'A x = A'b has the square of A's condition number, and
// loses twice as many digits as a method that works on A itself. Sources: Golub and Van Loan, "Matrix
// Computations", 4th edition, section 5.3.7; Higham, "Accuracy and Stability of Numerical Algorithms", 2nd
// edition, theorem 19.5 and section 20.4.
#pragma once

#include <functional>
#include <vector>

#include "solver/linearSolver.h"
#include "solver/study/history.h"

namespace solver::study {

// The signature of solve_normal_equations in solver/normal_equations.h.
using NormalEquationsFunction =
    std::function<double(int rows, int cols, implicitMatrix* A, implicitMatrix* A_transposed, double x[],
                         double b[], double epsilon, int* steps)>;

inline constexpr double kRounding = 0x1p-53;  // u

// Relative errors ||x - x*|| / ||x*||; NaN if a method found no solution.
struct DigitsLost {
  double condition = 1;
  double conj_grad = 0;  // on A'A, by the studied function
  int iterations = 0;    // that conj_grad took
  bool stopped = false;  // conj_grad used all iterations without an end: its error says nothing
  double cholesky = 0;   // on A'A as a dense matrix (Eigen's LLT)
  double qr = 0;         // on A: Householder (Eigen)
};

inline constexpr int kDigitsUnknowns = 40;

// A is 40 x 40 and not symmetric; its singular values run from 1/condition to 1, with evenly spaced
// logarithms. The errors are medians over `draws` matrices and solutions. The solver runs until rounding
// stops its progress, or until most_iterations.
DigitsLost digits_lost(const NormalEquationsFunction& solve, double condition, int draws,
                       int most_iterations);

}  // namespace solver::study
