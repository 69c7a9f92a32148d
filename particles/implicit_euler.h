// H4. Linearly implicit Euler: one Newton step of v(t+h) = v + h f(x + h v(t+h), v(t+h)) / m. Sources: the
// lecture, "K = infinity -> implicit integration?"; D. Baraff and A. Witkin, "Large Steps in Cloth Simulation"
// (SIGGRAPH 1998), equation (6), and section 5.3 for pinned particles.
//
// Both functions that solve do so for a change of velocity dv, in
//
//   (M - a df/dv - a b df/dx) dv = a (f + b df/dx v),
//
// with masses M and everything on the right at the given state. a is the time for which the force acts, b that
// for which the new velocity moves the particles: a = b = h is linearly implicit Euler, a = h/2 and b = h the
// lecture's filter, which H6 uses twice. df/dx is known by products alone, and the matrix by its own.
//
// Pinned particles keep their velocity: their rows and columns of the matrix are those of the identity, and
// their entries of the right-hand side are 0. (df/dx v on the right still sees the velocity that they have.)
#pragma once

#include <memory>

#include "particles/force.h"
#include "particles/state.h"
#include "solver/linearSolver.h"

namespace particles {

// Of the residual, relative to the right-hand side. Hair is light and stiff: at 1e-6 a hair of 30 segments gets
// velocities wrong by centimetres a second, at 1e-4 it does not notice gravity.
inline constexpr double kSolveTolerance = 1e-10;

// Columns of 3n numbers that `scratch` has.
inline constexpr int kImplicitScratch = 6;

struct SolveReport {
  int steps = 0;        // of ConjGrad, all calls together
  double residual = 0;  // ||right-hand side - matrix dv||, the square root of what ConjGrad returned
  double rhs = 0;       // ||right-hand side||
  bool converged = false;
};

// The matrix above. matVecMult takes one product with df/dx and one with df/dv, and allocates nothing (or the matrix
// is written out as a table, once, by 3n of each). Refers to force, particles and state, which must outlive it.
std::unique_ptr<implicitMatrix> implicit_matrix(const Force& force, const Particles& particles,
                                                const State& state, double a, double b);

// Solves the system above with ConjGrad and writes dv, 3n. Converged is a residual <= tolerance * rhs.
//
// ConjGrad gets max(100, 20 * 3n) steps. A stiff system can't be solved to any tolerance: rounding leaves a residual
// of about 2^-53 ||matrix|| (||dv|| + ||rhs||), and a ConjGrad that is asked for less uses all steps up and ends
// anywhere, metres a second off. So where all of them are used up, it may be asked again, for a residual a hundred times
// as large each time, until it gets there, but for none above 1e-6; `converged` stays false. A matrix that is not positive definite, or
// numbers that are not finite, end ConjGrad early: then `converged` is false and dv what it had.
SolveReport solve_implicit(const Force& force, const Particles& particles, const State& state, double a,
                           double b, double tolerance, Output dv, Scratch scratch);

// One step of h seconds, h > 0: dv as above with a = b = h, then v += dv and x += h v. Takes one evaluation of
// the force; it allocates nothing beyond what ConjGrad does.
SolveReport implicit_euler(const Force& force, const Particles& particles, double h, double tolerance,
                           State& state, Scratch scratch);

}  // namespace particles
