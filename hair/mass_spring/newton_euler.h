// Implicit Euler solved to convergence: H4's equation
//
//   M (u - v) = h f(x + h u, u),   then v(t+h) = u and x(t+h) = x + h u,
//
// H4 takes only the first step of Newton's method; this takes all of them. H4's error is compared with it: it
// separates the cost of the linearisation from the cost of the order. Not meant for hair: a step costs
// several of H4's solves.
//
// A Newton step solves H4's matrix (implicit_matrix, at x + h u and u) for the remaining residual, with a
// preconditioner if there is one. If hair is
// compressed or bent that matrix may be indefinite; then the step uses the definite one. Each such step is a
// descent direction of |u - v|_M^2 / 2 + E(x + h u), which u minimises if the forces have an energy. A step
// that goes too far is halved. Source: J. Nocedal and S. J. Wright, "Numerical Optimization" (2006), chapters
// 3 and 7 (inexact Newton methods).
#pragma once

#include "particles/force.h"
#include "particles/preconditioner.h"
#include "particles/state.h"

namespace hair {

// `scratch` has this many columns of 3n numbers.
inline constexpr int kNewtonScratch = particles::kPreconditionerScratch + 7;

struct NewtonReport {
  int newton_steps = 0;
  long solver_steps = 0;   // iterations of ConjGrad
  int plain_solves = 0;    // without a preconditioner
  int definite_steps = 0;  // Newton steps with the definite matrix
  int halvings = 0;        // of steps that went too far: each evaluates the forces once more
  bool converged = false;
};

// One step of h > 0 seconds. `force` has exact products; `definite` is the same force with definite products.
// Evaluates the forces once, and once more for each Newton step and each halving. `converged`: the last
// Newton step changed no velocity by more than 1e-12 of the largest, or moved no particle by more than 2^-50
// of the largest position, a few roundings. If not converged, the state is that of the last step. Pinned
// particles keep their velocity. Allocates only what implicit_matrix and ConjGrad allocate.
NewtonReport newton_euler(const particles::Force& force, const particles::Force& definite,
                          const particles::Particles& particles, double h, particles::State& state,
                          particles::Scratch scratch);

}  // namespace hair
