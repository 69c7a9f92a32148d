// Implicit Euler, solved to convergence: of H4's equation
//
//   M (u - v) = h f(x + h u, u),   then v(t+h) = u and x(t+h) = x + h u,
//
// H4 takes the first step of Newton's method, and this all. It is what H4's error is compared with: what the
// linearisation costs, and what the order costs. No method for hair: a step costs several of H4's solves.
//
// A Newton step solves H4's matrix (implicit_matrix, at x + h u and u) for what is left of the equation. Where hair is
// compressed or bent that matrix may not be definite; then the step is that of the definite one, from which every step
// leads downhill of |u - v|_M^2 / 2 + E(x + h u), which u makes least where forces have an energy. A step that goes
// too far along its way is halved. Source: J. Nocedal and S. J. Wright, "Numerical Optimization" (2006), chapters 3
// and 7 (inexact Newton methods).
#pragma once

#include "particles/force.h"
#include "particles/state.h"

namespace hair {

// Columns of 3n numbers that `scratch` has.
inline constexpr int kNewtonScratch = 5;

struct NewtonReport {
  int newton_steps = 0;
  long solver_steps = 0;   // of ConjGrad
  int definite_steps = 0;  // Newton steps with the definite matrix
  int halvings = 0;        // of steps that went too far: each evaluates the forces once more
  bool converged = false;
};

// One step of h > 0 seconds. Products of `force` are exact, those of `definite`, which is the same force, definite.
// The forces are evaluated once, once for each Newton step and once for each halving. Converged: the last Newton step
// changed no velocity by more than 1e-12 of the largest, or moved no particle by more than 2^-50 of the largest
// position, a few roundings. If not, the state is as the last step left it. Pinned particles keep their velocity.
// Allocates what implicit_matrix and ConjGrad do.
NewtonReport newton_euler(const particles::Force& force, const particles::Force& definite,
                          const particles::Particles& particles, double h, particles::State& state,
                          particles::Scratch scratch);

}  // namespace hair
