// P2. Constraints that hold by forces: rods and circular wires. Sources: A. Witkin and D. Baraff, "Physically
// Based Modeling: Principles and Practice" (SIGGRAPH 1997 course), "Constrained Dynamics", section 2; the
// feedback: J. Baumgarte (1972).
//
// All constraints together are C(x) = 0, one row after the other: first one for each rod, in their order,
// then two for each wire, in theirs.
//
//   rod i, j   C = (|x_i - x_j|^2 - length^2) / 2                                      m^2
//   wire i     C = (|x_i - centre|^2 - radius^2) / 2,  then C = normal . (x_i - centre)    m^2, m
//
// With J = dC/dx (a row for each C, 3n columns), J' the rate at which J changes along v, and W the inverse
// masses, 0 for those that are pinned, the constraint force is J^T lambda, where
//
//   J W J^T lambda = -J' v - J W f - stiffness C - damping J v.
//
// Then the acceleration a = W (f + J^T lambda) gives C'' = J a + J' v = -stiffness C - damping C'. The first
// two terms on the right keep constraints that hold; the last two, the feedback, take away what errors have
// summed up to, and are 0 while constraints hold. f is all other force on the particles, and a pinned
// particle moves with the velocity that it has.
#pragma once

#include <memory>

#include "particles/constraints.h"
#include "particles/state.h"
#include "solver/linearSolver.h"

namespace particles {

struct ConstraintReport {
  int steps;        // of ConjGrad
  double residual;  // ||right-hand side - J W J^T lambda||, as ConjGrad returned it (its square root)
};

// C = C(x): overwrites all rows.
void constraint_values(const Constraints& constraints, Input x, Output C);

// rates = J v: overwrites all rows.
void constraint_rates(const Constraints& constraints, Input x, Input v, Output rates);

// f += J^T lambda.
void add_constraint_forces(const Constraints& constraints, Input x, Input lambda, Output f);

// The matrix J W J^T as products: rows() x rows(), symmetric, positive semi-definite. It is singular where
// constraints are redundant (the same rod twice) or hold nothing (a rod of length 0, or between pinned
// particles). It refers to all three arguments, which must outlive it, and to their values at each product.
std::unique_ptr<implicitMatrix> constraint_matrix(const Constraints& constraints, const Particles& particles,
                                                  const State& state);

// Solves the equation above with ConjGrad, to a residual of 1e-10 of the right-hand side in at most max(100,
// 20 rows()) steps, and writes lambda (overwritten, rows() entries).
//
// Redundant constraints share their force: any lambda that solves the equation will do, and W J^T lambda is
// the same for all. ConjGrad finds one wherever there is one, because its first guess, the right-hand side,
// is in the span of J W J^T, and it never leaves that. Where the right-hand side contradicts itself (two rods
// of different lengths between the same particles, with feedback; a rod of length 0 whose ends part) there is
// none: it ends, the report has a residual above the tolerance, and lambda may be as large as numbers go.
ConstraintReport solve_constraints(const Constraints& constraints, const Particles& particles,
                                   const State& state, Input f, Output lambda);

}  // namespace particles
