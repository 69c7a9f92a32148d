// The lecture's interface to linear systems: an implicit matrix, and the method of conjugate gradients.
// Sources: A. Treuille, "Hair Simulation (and Rendering)", section "Solving Linear Systems"; M. R. Hestenes
// and E. Stiefel, "Methods of Conjugate Gradients for Solving Linear Systems", J. Res. NBS 49 (1952),
// equations (3:1a-f).
#pragma once

// The lecture's programs print, and include nothing but this header.
#include <cstdio>

// A square matrix A that is known by its products alone.
class implicitMatrix {
 public:
  virtual ~implicitMatrix() = default;

  // b = A x. Overwrites all of b, whatever it held; leaves x alone. x and b do not overlap.
  virtual void matVecMult(double x[], double b[]) = 0;
};

// Solve Ax = b for a symmetric, positive definite matrix A, by the method of conjugate gradients.
//
//   n        the number of unknowns, n >= 0; x and b hold n values each and do not overlap
//   x        output only. The first guess is x = b; what the caller left in x never matters
//   b        the right-hand side; it is not changed
//   epsilon  bounds the SQUARED residual norm: the loop ends as soon as ||b - Ax||^2 <= epsilon.
//            It may be 0; a negative one is never reached
//   steps    in: the most iterations, where 0 stands for max(100, 2n) and a negative number for none;
//            out: the iterations taken
//   returns  ||b - Ax||^2 of the x that is returned, as the recurrence has it
//
// An iteration takes one product. The recurrence's residual drifts away from the true one by rounding, so
// each 64th iteration replaces it by b - Ax of its new x, before epsilon is looked at, which takes one
// product more; and the first residual takes one:
//
//   products = 1 + steps + floor(steps / 64).
//
// With u = 2^-53, e the relative rounding error of one product over u (about the non-zeros in a row), the
// exact solution x* and X = 2||x*|| + ||b||, the square root of the return value differs from the true ||b -
// Ax|| by at most
//
//   64 (10 + 2e) u ||A|| X
//
// and n u of itself, from adding the squares up. There are at most 64 updates since the residual was last
// replaced; one rounds x by u (||x|| + 2||alpha d||), r by u (||r|| + ||alpha Ad||) and the product by e u
// ||A|| ||alpha d||, where no iterate is longer than X, no update longer than 2X and no residual longer than
// ||A|| X, because the error ||x_k - x*|| only ever shrinks from ||b - x*|| on (Greenbaum, "Iterative
// Methods", 1997, section 7.3; ||A|| stands for the norm of the matrix of all |a_ij|, at most the square root
// of the largest row sum times the largest column sum).
//
// What can't be solved ends, too. A direction d with d'Ad <= 0 (A is not positive definite), or a value that
// is not finite, ends the loop at once with the last x that was finite: one whose own residual is not finite
// counts, one that overflows does not. The iteration that fails counts as a step and takes no more products
// (if it is a 64th and fails before its x is there, one less than above). The return value is that x's, so it
// is then never <= epsilon by accident: it is a number > epsilon, an infinity or a NaN. If the first residual
// is not finite, no step is taken. (The first guess is b: if that is not finite, neither is x.) n = 0
// returns 0 after 0 steps, with or without the first product. b = 0 returns 0 after 0 steps if epsilon >= 0.
//
// Multiplying b by 2^k and epsilon by 2^(2k), for |k| <= 465, gives the same steps and 2^k times the x, bit
// by bit as long as no product of two values that matters leaves the range of normal numbers, 2^-1022 to
// 2^1024. (2^930 leaves a factor of 2^90 on either side: a b and an A of ordinary size stay within it.)
//
// ConjGrad never hangs, never prints, and keeps no state from call to call.
double ConjGrad(int n, implicitMatrix* A, double x[], double b[], double epsilon, int* steps);
