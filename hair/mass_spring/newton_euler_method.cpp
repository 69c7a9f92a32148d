#include "hair/mass_spring/newton_euler.h"
#include "hair/mass_spring/step_methods.h"

namespace hair {

namespace {

StepOutcome take_newton_step(MovingStrand& moving, const StepOptions& options,
                             const particles::Scratch& scratch) {
  const NewtonReport report =
      newton_euler(moving.force, moving.definite_force, moving.particles, options.h, moving.state, scratch);
  return {.solver_steps = report.solver_steps,
          .plain_solves = report.plain_solves,
          .solves = 1,
          .unconverged = !report.converged,
          .correction_steps = report.newton_steps,
          .halvings = report.halvings,
          .suspect = Stage::filter};
}

}  // namespace

const StepMethod kNewtonEuler{
    .step = take_newton_step, .scratch = kNewtonScratch, .needs_definite_force = true};

}  // namespace hair
