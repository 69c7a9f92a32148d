#include "hair/simulation/methods.h"

#include "hair/mass_spring/step_methods.h"
#include "particles/explicit_integrators.h"

namespace hair {

namespace {

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

using particles::ToyMethod;

constexpr std::string_view kExplicit[] = {"P1"};
constexpr std::string_view kImplicit[] = {"S1", "H4"};
constexpr std::string_view kCorrected[] = {"S1", "H4", "H5", "H6"};

constexpr MethodRow kMethods[] = {
    {.id = "forward_euler",
     .name = "forward Euler",
     .exercises = kExplicit,
     .order = 1,
     .evaluations = 1,
     .is_explicit = true,
     .polynomial = 1,
     .limit = "the least of 2 zeta/omega and 2/|lambda|",
     .energy = "gains energy with each step, of first order",
     .springs = &kExplicitStep<particles::forward_euler>,
     .toy = ToyMethod::forward_euler},
    {.id = "symplectic_euler",
     .name = "symplectic Euler",
     .exercises = kExplicit,
     .order = 1,
     .evaluations = 1,
     .is_explicit = true,
     .limit = "2 (sqrt(1 + zeta^2) - zeta)/omega",
     .energy = "has an energy that swings about the true one and does not drift",
     .springs = &kExplicitStep<particles::symplectic_euler>,
     .toy = ToyMethod::symplectic_euler},
    {.id = "midpoint",
     .name = "midpoint",
     .exercises = kExplicit,
     .order = 2,
     .evaluations = 2,
     .is_explicit = true,
     .polynomial = 2,
     .limit = "|1 + z + z^2/2| = 1",
     .energy = "gains energy with each step, of third order",
     .springs = &kExplicitStep<particles::midpoint>,
     .toy = ToyMethod::midpoint},
    {.id = "runge_kutta_4",
     .name = "Runge-Kutta 4",
     .exercises = kExplicit,
     .order = 4,
     .evaluations = 4,
     .is_explicit = true,
     .polynomial = 4,
     .limit = "RK4's |R(h lambda)| = 1",
     .energy = "loses energy with each step, of fifth order",
     .springs = &kExplicitStep<particles::runge_kutta_4>,
     .toy = ToyMethod::runge_kutta_4},
    {.id = "implicit_euler",
     .name = "implicit Euler",
     .exercises = kImplicit,
     .order = 1,
     .evaluations = 1,
     .limit = "what its matrix leaves out",
     .energy = "loses energy with each step, of first order: its error is damping",
     .springs = &kImplicitEuler,
     .toy = ToyMethod::implicit_euler},
    {.id = "predictor_corrector",
     .name = "predictor and corrector",
     .exercises = kCorrected,
     .order = 1,
     .evaluations = 2,  // one for each of its two solves
     .keeps_lengths = true,
     .limit = "across the hair",
     .energy = "loses energy with each step, less than implicit Euler, as lengths are kept",
     .springs = &kPredictorCorrector},
};

}  // namespace

Method MethodRow::method() const {
  return static_cast<Method>(this - kMethods);
}

std::span<const MethodRow> methods() {
  return kMethods;
}

const MethodRow& row_of(Method method) {
  return kMethods[static_cast<std::size_t>(method)];
}

}  // namespace hair
