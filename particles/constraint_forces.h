// P2. Constraints that hold by forces: rods and circular wires. Sources: A. Witkin and D. Baraff, "Physically
// Based Modeling: Principles and Practice" (SIGGRAPH 1997 course), "Constrained Dynamics", section 2; the
// feedback: J. Baumgarte (1972).
//
// All constraints together are C(x) = 0, one row after the other: first one row for each rod, then two rows
// for each wire, in the order of the lists.
//
//   rod i, j   C = (|x_i - x_j|^2 - length^2) / 2                                      m^2
//   wire i     C = (|x_i - centre|^2 - radius^2) / 2,  then C = normal . (x_i - centre)    m^2, m
//
// Let J = dC/dx (a row for each C, 3n columns), J' the rate at which J changes along v, and W the diagonal
// matrix of the inverse masses, with 0 for pinned particles. The constraint force is J^T lambda, where
//
//   J W J^T lambda = -J' v - J W f - stiffness C - damping J v.
//
// Then the acceleration a = W (f + J^T lambda) gives C'' = J a + J' v = -stiffness C - damping C'. The first
// two terms on the right keep satisfied constraints satisfied. The last two, the feedback, remove accumulated
// errors; they are 0 while constraints hold. f is the sum of all other forces on the particles. A pinned
// particle keeps its velocity.
#pragma once

#include <memory>

#include "particles/constraints.h"
#include "particles/state.h"
#include "solver/linearSolver.h"

namespace particles {

struct ConstraintReport {
  int steps;        // iterations of ConjGrad
  double residual;  // ||right-hand side - J W J^T lambda||, as ConjGrad returned it (its square root)
};

// C = C(x): overwrites all rows.
void constraint_values(const Constraints& constraints, Input x, Output C);

// rates = J v: overwrites all rows.
void constraint_rates(const Constraints& constraints, Input x, Input v, Output rates);

// f += J^T lambda.
void add_constraint_forces(const Constraints& constraints, Input x, Input lambda, Output f);

// The matrix J W J^T, as an implicitMatrix: rows() x rows(), symmetric, positive semi-definite. It is
// singular if constraints are redundant (the same rod twice) or constrain nothing (a rod of length 0, or one
// between pinned particles). It keeps references to all three arguments, which must outlive it; each product
// uses their values at that moment.
std::unique_ptr<implicitMatrix> constraint_matrix(const Constraints& constraints, const Particles& particles,
                                                  const State& state);

// Solves the equation above with ConjGrad, to a residual norm of 1e-10 times that of the right-hand side, in
// at most max(100, 20 rows()) iterations, and writes lambda (overwritten, rows() entries).
//
// Redundant constraints share their force: any lambda that solves the equation is a valid answer, and W J^T
// lambda is the same for all of them. ConjGrad finds a solution if there is one: its first guess, the
// right-hand side, is in the range of J W J^T, and so are all later iterates.
//
// There is no solution if the right-hand side contradicts itself. Redundant constraints agree with each other
// only as far as they hold: if lengths are off by a part e, the feedback's terms disagree by about e^2. If
// that is more than the tolerance, ConjGrad uses up its iterations, and may (need not) be called again with a
// tolerance a hundred times as large each time, but never with one above 1e-6; `steps` adds up all calls. Two
// rods of different lengths between the same particles, with feedback, or a rod of length 0 whose ends move
// apart, contradict each other at any tolerance: then the function still returns, the report has a residual
// above the tolerance, and lambda may be arbitrarily large.
// If all forces cancel, the right-hand side contains only rounding errors, which contradict each other:
// callers then take lambda = 0 without a solve (particles/toys/toy_constraints.cpp).
ConstraintReport solve_constraints(const Constraints& constraints, const Particles& particles,
                                   const State& state, Input f, Output lambda);

}  // namespace particles
