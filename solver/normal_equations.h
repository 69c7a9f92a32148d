// Example 3 of the lecture: what if A is not symmetric, or not positive definite, or not even square?
// Then solve the normal equations,
//
//   A'A x = A'b,
//
// whose matrix A'A is symmetric, and positive definite if A's columns are linearly independent. If A is
// square and regular, x solves Ax = b; if A has more rows than columns, x makes ||b - Ax|| smallest (least
// squares). The price is the condition number: cond(A'A) = cond(A)^2 (Golub and Van Loan, "Matrix
// Computations", 4th edition, section 5.3.7).
//
// In all functions A has `rows` rows and `cols` columns, rows >= 0 and cols >= 0, and A' is its transpose.
#pragma once

#include <memory>

#include "solver/linearSolver.h"

// A matrix from the table of its entries: the entry in row i and column j is a[i * cols + j].
//
//   matVecMult(x, b)  b_i = sum_j a_ij x_j, with cols values in x and rows values in b
//
// The table is copied: the caller may change or free `a` afterwards.
std::unique_ptr<implicitMatrix> dense_matrix(int rows, int cols, const double a[]);

// The matrix A'A, computed only from products with A and with A'.
//
//   A                 matVecMult takes cols values to rows values
//   A_transposed      matVecMult takes rows values to cols values
//   matVecMult(x, b)  b = A'(A x), with cols values in x and in b: one product with A and one with A', and
//                     no other work; it allocates nothing
//
// The result keeps A and A_transposed as pointers, and owns neither.
std::unique_ptr<implicitMatrix> normal_matrix(int rows, int cols, implicitMatrix* A,
                                              implicitMatrix* A_transposed);

// Solve A'A x = A'b with ConjGrad.
//
//   x        cols values, output only
//   b        rows values, not changed
//   epsilon  bounds ||A'(b - Ax)||^2, the SQUARED residual norm of the normal equations
//   steps    as in ConjGrad; its header covers a singular A'A and values that are not finite
//   returns  ConjGrad's result: ||A'(b - Ax)||^2
//
// Takes 1 + steps + floor(steps / 64) products with A, and one more product than that with A'.
double solve_normal_equations(int rows, int cols, implicitMatrix* A, implicitMatrix* A_transposed, double x[],
                              double b[], double epsilon, int* steps);
