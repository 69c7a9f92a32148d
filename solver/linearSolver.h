// The lecture's interface to linear systems: an implicit matrix, and the method of conjugate gradients.
// Sources: A. Treuille, "Hair Simulation (and Rendering)", section "Solving Linear Systems"; M. R. Hestenes
// and E. Stiefel, "Methods of Conjugate Gradients for Solving Linear Systems", J. Res. NBS 49 (1952),
// equations (3:1a-f).
#pragma once

// The lecture's programs print, and include nothing but this header.
#include <cstdio>

// A square matrix A that is available only through its products A x.
class implicitMatrix {
 public:
  virtual ~implicitMatrix() = default;

  // b = A x. Overwrites all of b and does not change x. x and b do not overlap.
  virtual void matVecMult(double x[], double b[]) = 0;
};

// Solve Ax = b for a symmetric, positive definite matrix A, by the method of conjugate gradients.
//
//   n        the number of unknowns, n >= 0; x and b hold n values each and do not overlap
//   x        output only. The first guess is x = b; the caller's values in x are ignored
//   b        the right-hand side; it is not changed
//   epsilon  bounds the SQUARED residual norm: the loop ends as soon as ||b - Ax||^2 <= epsilon.
//            It may be 0; a negative epsilon is never reached
//   steps    in: the maximum number of iterations; 0 stands for max(100, 2n), a negative number for none;
//            out: the number of iterations taken
//   returns  ||b - Ax||^2 of the returned x, as the recurrence computes it
//
// The first residual takes one product, and each iteration takes one. Rounding makes the recurrence's
// residual drift away from the true one. So every 64th iteration replaces it by b - Ax of the new x, before
// it is compared with epsilon. Everything else, including beta, stays the same. This takes one more product:
//
//   products = 1 + steps + floor(steps / 64).
//
// Let u = 2^-53, e the relative rounding error of one product divided by u (about the number of non-zeros in
// a row), x* the exact solution and X = 2||x*|| + ||b||. Then the square root of the return value differs
// from the true ||b - Ax|| by at most
//
//   64 (10 + 2e) u ||A|| X
//
// plus n u times itself, from adding the squares up. Derivation: the residual is replaced after at most 64
// updates. One update rounds x by u (||x|| + 2||alpha d||), r by u (||r|| + ||alpha Ad||) and the
// product by e u ||A|| ||alpha d||. No iterate is longer than X, no update longer than 2X and no residual
// longer than ||A|| X, because the error ||x_k - x*|| never grows; it starts at ||b - x*|| (Greenbaum,
// "Iterative Methods", 1997, section 7.3). Here ||A|| stands for the norm of the matrix of all |a_ij|, at
// most the square root of the largest row sum times the largest column sum.
//
// Systems that can't be solved end too. The loop ends at once if a direction d has d'Ad <= 0 (A is not
// positive definite) or if a value is not finite. It then returns the last finite x, even if the residual of
// that x is not finite. The iteration that fails counts as a step and takes no more products (a 64th
// iteration that fails before it has a new x takes one product less than the formula above). The return value
// is the squared residual of the returned x: a number > epsilon, an infinity or a NaN, so that a failure
// never looks like a success. If the first residual is not finite, no step is taken. (The first guess is b:
// if b is not finite, x is not finite either.) n = 0 returns 0 after 0 steps, with or without the first
// product. b = 0 returns 0 after 0 steps if epsilon >= 0.
//
// Multiplying b by 2^k and epsilon by 2^(2k), for |k| <= 465, gives the same steps and 2^k times the same x,
// bit by bit, as long as no relevant product of two values leaves the range of normal numbers, 2^-1022 to
// 2^1024. (2^930 leaves a factor of 2^90 on either side: a b and an A of ordinary size stay within it.)
//
// ConjGrad never hangs, never prints, and keeps no state from call to call.
double ConjGrad(int n, implicitMatrix* A, double x[], double b[], double epsilon, int* steps);
