// H4. Linearly implicit Euler: one Newton step of v(t+h) = v + h f(x + h v(t+h), v(t+h)) / m. Sources: the
// lecture, "K = infinity -> implicit integration?"; D. Baraff and A. Witkin, "Large Steps in Cloth Simulation"
// (SIGGRAPH 1998), equation (6), and section 5.3 for pinned particles.
//
// Both functions below work with the equation for the change of velocity dv,
//
//   (M - a df/dv - a b df/dx) dv = a (f + b df/dx v),
//
// with the masses M and everything at the given state. a is the time for which the force acts, b the time for
// which the new velocity moves the particles: a = b = h is linearly implicit Euler; a = h/2 and b = h is the
// lecture's filter, which H6 uses twice. df/dx is available only through products, and so is the matrix.
//
// Pinned particles keep their velocity: their rows and columns of the matrix are those of the identity, and
// their entries of the right-hand side are 0. (In df/dx v on the right, v still includes their velocity.)
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

// `scratch` has this many columns of 3n numbers: those of the preconditioner and seven more.
inline constexpr int kImplicitScratch = kPreconditionerScratch + 7;

// With a preconditioner, the system is solved at most so often, each time for the residual that is left.
inline constexpr int kMostSolves = 3;

struct SolveReport {
  int steps = 0;        // iterations of ConjGrad, all calls together
  double residual = 0;  // ||right-hand side - matrix dv||, the square root of what ConjGrad returned
  double rhs = 0;       // ||right-hand side||
  bool converged = false;
  bool preconditioned = false;  // ConjGrad was called with a preconditioner
};

// The matrix above. matVecMult takes one product with df/dx and one with df/dv, and allocates nothing. (An
// implementation may instead build the matrix as a table once, by 3n of each product.) It keeps references to
// force, particles and state, which must outlive it.
std::unique_ptr<implicitMatrix> implicit_matrix(const Force& force, const Particles& particles,
                                                const State& state, double a, double b);

// Solves the system above with ConjGrad and writes dv, 3n entries. `converged` means residual <= tolerance *
// rhs, or, with a preconditioner, that rounding allows no less.
//
// With a preconditioner (particles/preconditioner.h; if one exists for these forces) dv starts at 0. Each solve takes
// the residual r = rhs - matrix dv, solves (L^-1 matrix L^-T) y = L^-1 r by ConjGrad to `tolerance`, relative to
// L^-1 r (to 1e-14 if it is smaller), and adds L^-T y to dv. ConjGrad gets max(100, 3n) iterations. The residual is
// then computed anew: what counts is its norm, and not that of L^-1 r. At most kMostSolves times, and no more if the
// residual does not fall (that y is not added), or if it has reached the tolerance or Preconditioner::rounding_allows
// it. A solution that makes no use of the preconditioner is right, too, and slow.
//
// Without one, ConjGrad gets the matrix itself, and max(100, 20 * 3n) iterations. Rounding limits the tolerance that a
// stiff system can reach: it leaves a residual of about 2^-53 ||matrix|| (||dv|| + ||rhs||). If ConjGrad is asked for
// less than that, it uses all iterations and ends anywhere, metres per second off. So if all iterations are used up, it
// may be called again with a tolerance a hundred times as large each time, until it reaches it, but never with one
// above 1e-6; `converged` stays false. ConjGrad ends early if the matrix is not positive definite or a number
// is not finite: then `converged` is false and dv is the last x of ConjGrad.
SolveReport solve_implicit(const Force& force, const Particles& particles, const State& state, double a,
                           double b, double tolerance, Output dv, Scratch scratch);

// One step of h seconds, h > 0: dv as above with a = b = h, then v += dv and x += h v. Evaluates the force
// once and allocates nothing; ConjGrad's own memory does not count.
SolveReport implicit_euler(const Force& force, const Particles& particles, double h, double tolerance,
                           State& state, Scratch scratch);

}  // namespace particles
