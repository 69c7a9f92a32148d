#include "hair/scene/toy_methods.h"
#include "particles/explicit_integrators.h"

namespace hair {

namespace {

using Integrator = void (*)(particles::Dynamics&, double, particles::Output, particles::Output,
                            particles::Scratch);

template <Integrator integrator>
void take_step(MovingToy& moving, const StepOptions& options, const particles::Scratch& scratch) {
  integrator(*moving.dynamics, options.h, moving.state.x, moving.state.v, scratch);
}

template <Integrator integrator>
constexpr ToyStep kStep{take_step<integrator>, particles::kIntegratorScratch};

}  // namespace

const ToyStep kToyForwardEuler = kStep<particles::forward_euler>;
const ToyStep kToySymplecticEuler = kStep<particles::symplectic_euler>;
const ToyStep kToyMidpoint = kStep<particles::midpoint>;
const ToyStep kToyRungeKutta4 = kStep<particles::runge_kutta_4>;

}  // namespace hair
