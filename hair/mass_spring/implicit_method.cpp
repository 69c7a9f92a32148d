#include "hair/mass_spring/step_methods.h"
#include "particles/implicit_euler.h"

namespace hair {

namespace {

StepOutcome take_implicit_step(MovingStrand& moving, const StepOptions& options,
                               const particles::Scratch& scratch) {
  return outcome_of(particles::implicit_euler(moving.force, moving.particles, options.h, options.tolerance,
                                              moving.state, scratch));
}

}  // namespace

const StepMethod kImplicitEuler{
    .step = take_implicit_step, .scratch = particles::kImplicitScratch, .goes_straight_on = true};

}  // namespace hair
