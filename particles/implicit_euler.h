// H4. Linearly implicit Euler: one Newton step of v(t+h) = v + h f(x + h v(t+h), v(t+h)) / m. Sources: the
// lecture, "K = infinity -> implicit integration?"; D. Baraff and A. Witkin, "Large Steps in Cloth
// Simulation" (SIGGRAPH 1998), equation (6), and section 5.3 for pinned particles.
//
// The change of velocity dv solves
//
//   (M - a df/dv - a b df/dx) dv = a (f + b df/dx v),
//
// with the masses M and everything at the given state. a is the time for which the force acts, b the time for
// which the new velocity moves the particles: a = b = h is linearly implicit Euler; a = h/2 and b = h is the
// lecture's filter, which H6 uses twice. df/dx is available only through products, and so is the matrix.
//
// solve_implicit (particles/solve_implicit.h) is given. It calls implicit_matrix, implicit_rhs and, where the
// forces have no preconditioner, solve_plain.
#pragma once

#include <memory>

#include "particles/force.h"
#include "particles/preconditioner.h"
#include "particles/state.h"
#include "solver/linearSolver.h"

namespace particles {

// Relative tolerance of the residual: residual / right-hand side. Hair is light and stiff: at 1e-6 the
// velocities of a hair of 30 segments are wrong by centimetres per second; at 1e-4 the hair does not notice
// gravity.
inline constexpr double kSolveTolerance = 1e-10;

// `scratch` has this many columns of 3n numbers. solve_implicit leaves the last one alone.
inline constexpr int kImplicitScratch = kPreconditionerScratch + 5;

struct SolveReport {
  int steps = 0;                // iterations of ConjGrad
  double residual = 0;          // ||rhs - matrix dv||, the square root of what ConjGrad returned
  double rhs = 0;               // ||rhs||, of the right-hand side
  bool converged = false;       // residual <= tolerance * rhs
  bool preconditioned = false;  // set by solve_implicit alone: it had a preconditioner
};

// The matrix above. Pinned particles have the rows and columns of the identity. matVecMult takes one product
// with df/dx and one with df/dv. (An implementation may instead build the matrix as a table once, by 3n of
// each product.) It overwrites b and leaves x alone. It keeps references to force, particles and state, which
// must outlive it.
std::unique_ptr<implicitMatrix> implicit_matrix(const Force& force, const Particles& particles,
                                                const State& state, double a, double b);

// Writes the right-hand side above, 3n numbers. The entries of pinned particles are 0; v on the right still
// includes their velocity. Evaluates the force once, and takes one product with df/dx.
void implicit_rhs(const Force& force, const Particles& particles, const State& state, double a, double b,
                  Output rhs);

// Solves matrix dv = rhs by one call of ConjGrad, which may take `most_steps` >= 1 iterations, and writes dv.
// `tolerance` is relative: ConjGrad is asked for a residual of at most tolerance * ||rhs||. rhs is not
// changed; it is an Output because ConjGrad wants a double*. If the matrix is not positive definite, a number
// is not finite, or ConjGrad needs more iterations, `converged` is false, and dv is ConjGrad's last x.
SolveReport solve_plain(implicitMatrix& matrix, Output rhs, double tolerance, int most_steps, Output dv);

// One step of h seconds, h > 0: dv by solve_implicit with a = b = h, then v += dv and x += h v, with the new
// v. Returns the report of solve_implicit.
SolveReport implicit_euler(const Force& force, const Particles& particles, double h, double tolerance,
                           State& state, Scratch scratch);

}  // namespace particles
