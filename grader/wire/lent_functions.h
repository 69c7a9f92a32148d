// STAFF ONLY. Functions of prerequisites that the suite lends to a worker, by number, with the arguments and the
// results of a call. So the worker holds no code of the reference: each call goes to the suite.
//
// What such a function needs of its caller's objects, it asks back (callbacks), by the numbers of
// grader/wire/force_message.h, and kLentMatrix for a matrix. `held` is 1 if the force is the one that the suite
// serves in this request. Then the suite asks nobody.
#pragma once

namespace grader {

// S1
inline constexpr int kLentConjGrad = 1;  // n, epsilon, steps, b  -> value, steps, x

// H4. held, particles, state, then
inline constexpr int kLentImplicitProduct = 2;  // a, b, x          -> product
inline constexpr int kLentSolveImplicit = 3;    // a, b, tolerance  -> dv, steps, residual, rhs, converged
inline constexpr int kLentImplicitEuler = 4;    // h, tolerance     -> x, v, steps, residual, rhs, converged

// H5. strand, tolerance, most iterations, x; then v if it is there  -> what changes, iterations, error, converged
inline constexpr int kLentRelaxLengths = 5;
inline constexpr int kLentCorrectLengths = 6;
inline constexpr int kLentCorrectVelocities = 7;  // v

inline constexpr int kLentMatrix = 0;  // the operator of a callback: the matrix of ConjGrad's caller

}  // namespace grader
