#include "hair/mass_spring/step_methods.h"
#include "particles/implicit_euler.h"

namespace hair {

namespace {

StepOutcome take_implicit_step(MovingStrand& moving, const StepOptions& options,
                               const particles::Scratch& scratch) {
  const particles::SolveReport report = particles::implicit_euler(moving.force, moving.particles, options.h,
                                                                  options.tolerance, moving.state, scratch);
  return {.solver_steps = report.steps,
          .plain_solves = !report.preconditioned,
          .unconverged = !report.converged,
          .residual = left_by(report),
          .suspect = Stage::filter};
}

}  // namespace

const StepMethod kImplicitEuler{take_implicit_step, particles::kImplicitScratch, nullptr,
                                KeptEnergy::without_stretching};

}  // namespace hair
