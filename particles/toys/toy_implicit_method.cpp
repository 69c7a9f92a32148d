#include <algorithm>

#include "particles/implicit_euler.h"
#include "particles/toys/moving_toy.h"

namespace particles {

namespace {

void take_step(MovingToy& moving, const StepOptions& options, const Scratch& scratch) {
  const SolveReport report =
      implicit_euler(moving.force, moving.toy.particles, options.h, options.tolerance, moving.state, scratch);
  moving.solves.steps += report.steps;
  ++moving.solves.solves;
  if (report.converged) return;
  ++moving.solves.unconverged;
  moving.solves.left = std::max(moving.solves.left, report.residual / report.rhs);
}

}  // namespace

const ToyStep kToyImplicitEuler{take_step, kImplicitScratch};

}  // namespace particles
