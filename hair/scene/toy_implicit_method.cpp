#include "hair/scene/toy_methods.h"
#include "particles/implicit_euler.h"

namespace hair {

namespace {

void take_step(MovingToy& moving, const StepOptions& options, const particles::Scratch& scratch) {
  const particles::SolveReport report = particles::implicit_euler(
      moving.force, moving.toy.particles, options.h, options.tolerance, moving.state, scratch);
  moving.solves.steps += report.steps;
  moving.solves.unconverged += !report.converged;
}

}  // namespace

const ToyStep kToyImplicitEuler{take_step, particles::kImplicitScratch};

}  // namespace hair
