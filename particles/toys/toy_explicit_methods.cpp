#include "particles/explicit_integrators.h"
#include "particles/toys/moving_toy.h"

namespace particles {

namespace {

using Integrator = void (*)(Dynamics&, double, Output, Output, Scratch);

template <Integrator integrator>
void take_step(MovingToy& moving, const StepOptions& options, const Scratch& scratch) {
  integrator(*moving.dynamics, options.h, moving.state.x, moving.state.v, scratch);
}

template <Integrator integrator>
constexpr ToyStep kStep{take_step<integrator>, kIntegratorScratch};

}  // namespace

const ToyStep kToyForwardEuler = kStep<forward_euler>;
const ToyStep kToySymplecticEuler = kStep<symplectic_euler>;
const ToyStep kToyMidpoint = kStep<midpoint>;
const ToyStep kToyRungeKutta4 = kStep<runge_kutta_4>;

}  // namespace particles
