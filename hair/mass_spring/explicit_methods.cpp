#include "hair/mass_spring/step_methods.h"
#include "particles/explicit_integrators.h"

namespace hair {

namespace {

using Integrator = void (*)(particles::Dynamics&, double, particles::Output, particles::Output,
                            particles::Scratch);

template <Integrator integrator>
StepOutcome take_explicit_step(MovingStrand& moving, const StepOptions& options,
                               const particles::Scratch& scratch) {
  integrator(moving.system, options.h, moving.state.x, moving.state.v, scratch);
  return {.suspect = Stage::integration};
}

template <Integrator integrator>
// An explicit step costs no more than to read the strand's energy.
constexpr StepMethod kMethod{
    .step = take_explicit_step<integrator>, .scratch = particles::kIntegratorScratch, .read_every = 16};

}  // namespace

const StepMethod kForwardEuler = kMethod<particles::forward_euler>;
const StepMethod kSymplecticEuler = kMethod<particles::symplectic_euler>;
const StepMethod kMidpoint = kMethod<particles::midpoint>;
const StepMethod kRungeKutta4 = kMethod<particles::runge_kutta_4>;

}  // namespace hair
