// Matrices for testing a solver, with known properties. A product costs O(non-zeros).
#pragma once

#include <vector>

#include "solver/linearSolver.h"

namespace solver {

// An m x n matrix in compressed rows: row i holds values[k] in column columns[k],
// for row_begin[i] <= k < row_begin[i + 1].
class SparseMatrix : public implicitMatrix {
 public:
  struct Entry {
    int row, col;  // counted from 0
    double value;
  };

  // Entries may come in any order; entries for the same place add up. Throws std::invalid_argument for an
  // entry outside the matrix.
  SparseMatrix(int rows, int cols, const std::vector<Entry>& entries);

  // b = A x, with cols() values in x and rows() values in b.
  void matVecMult(double x[], double b[]) override;

  int rows() const { return static_cast<int>(row_begin_.size()) - 1; }
  int cols() const { return cols_; }
  std::vector<Entry> entries() const;  // by rows, then columns
  SparseMatrix transposed() const;
  double norm_bound() const;  // sqrt(||A||_1 ||A||_inf) >= ||A||_2, even with |a_ij| for a_ij
  int longest_row() const;    // the most non-zeros in a row: the rounding error of a product, in units of u

 private:
  int cols_;
  std::vector<int> row_begin_, columns_;
  std::vector<double> values_;
};

// diag(d).
SparseMatrix diagonal(const std::vector<double>& d);

// The n x n matrix with `main` on the diagonal and `off` beside it.
// Eigenvalues main + 2 off cos(k pi / (n + 1)), k = 1..n.
SparseMatrix tridiagonal(int n, double main, double off);

// The five-point Laplacian on an n x n grid with zero boundary values, times h^2: n^2 unknowns, 4 on the
// diagonal. Eigenvalues 4 - 2 cos(i pi / (n + 1)) - 2 cos(j pi / (n + 1)).
SparseMatrix poisson_2d(int n);

// H_ij = 1 / (i + j + 1), i and j from 0: symmetric, positive definite and nearly singular,
// cond(H) ~ e^(3.5 n).
SparseMatrix hilbert(int n);

// The matrix M + h^2 K of an implicit Euler step of a straight strand along z, clamped at its upper end:
// particle i has mass masses[i] (kg) and hangs from particle i - 1 by a spring of stiffness k (N/m) along z,
// and k_bend (N/m) across (x and y). 3 masses.size() unknowns, ordered x0 y0 z0 x1 y1 z1 ...; h in seconds.
SparseMatrix strand_implicit_euler(const std::vector<double>& masses, double k, double k_bend, double h);

// A = Q diag(spectrum) Q', where Q is a product of Householder reflections I - 2 v v'/(v'v). A is symmetric
// and full and has the given eigenvalues, but a product costs only O(n).
class SpectralMatrix : public implicitMatrix {
 public:
  // Each of `reflectors` holds spectrum.size() values, not all zero (else throws std::invalid_argument).
  SpectralMatrix(std::vector<double> spectrum, std::vector<std::vector<double>> reflectors);

  void matVecMult(double x[], double b[]) override;

  int size() const { return static_cast<int>(spectrum_.size()); }

 private:
  std::vector<double> spectrum_;
  std::vector<std::vector<double>> reflectors_;  // each has length 1
};

// c A, and the c for which ||b - c A b|| = ||b||: with it ConjGrad's first residual is as long as b.
SparseMatrix scaled(const SparseMatrix& A, double c);
double even_scale(implicitMatrix& A, const std::vector<double>& b);

// A symmetric, positive definite, full matrix and a right-hand side for which the lengths of ConjGrad's
// residuals are chosen: each is ratios[k] times as long as the one before, until the last step of
// `curvatures.size()` ends at 0. ratios[k] >= 1 makes a plateau or a rise. (ConjGrad's residuals, divided by
// their lengths, are the columns of a V with V'AV = L D L'. There D has the 1 / alpha[k], which are
// `curvatures` here, and L has 1 on its diagonal and -ratios[k] below: Saad, "Iterative Methods", 2003,
// section 6.7. V is the reflection along `mirror` here.)
struct PlannedSystem {
  SparseMatrix A;
  std::vector<double> b;
};
PlannedSystem planned_system(const std::vector<double>& curvatures, const std::vector<double>& ratios,
                             const std::vector<double>& mirror);

// n numbers from low to high whose logarithms are evenly spaced. n >= 2, 0 < low <= high.
std::vector<double> log_spaced(int n, double low, double high);

}  // namespace solver
