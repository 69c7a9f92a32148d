// A step by an explicit integrator: a function with P1's signature and any return type.
#pragma once

#include "hair/mass_spring/step_methods.h"
#include "particles/explicit_integrators.h"

namespace hair {

template <auto integrator>
StepOutcome take_explicit_step(MovingStrand& moving, const StepOptions& options,
                               const particles::Scratch& scratch) {
  integrator(moving.system, options.h, moving.state.x, moving.state.v, scratch);
  return {.suspect = Stage::integration};
}

// An explicit step is so cheap that reading the strand's energy would cost as much.
template <auto integrator, int scratch_columns = particles::kIntegratorScratch>
inline constexpr StepMethod kExplicitStep{
    .step = take_explicit_step<integrator>, .scratch = scratch_columns, .read_every = 16};

}  // namespace hair
