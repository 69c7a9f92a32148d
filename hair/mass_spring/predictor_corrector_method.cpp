#include <algorithm>
#include <cmath>

#include "hair/mass_spring/step_methods.h"
#include "hair/predictor_corrector.h"

namespace hair {

namespace {

bool is_finite(const particles::SolveReport& report) {
  return std::isfinite(report.rhs) && std::isfinite(report.residual);
}

StepOutcome predict_and_correct(MovingStrand& moving, const StepOptions& options,
                                const particles::Scratch& scratch) {
  const StepReport report = predictor_corrector(moving.force, moving.particles, moving.strand, options.h,
                                                options.tolerance, moving.state, scratch);
  StepOutcome outcome;
  outcome.solver_steps = report.filter.steps + report.second_filter.steps;
  outcome.plain_solves = !report.filter.preconditioned + !report.second_filter.preconditioned;
  outcome.solves = 3;
  outcome.unconverged =
      !report.filter.converged + !report.correction.converged + !report.second_filter.converged;
  outcome.residual = std::max(left_by(report.filter), left_by(report.second_filter));
  outcome.correction_steps = report.correction.iterations;
  outcome.suspect = !is_finite(report.filter)                 ? Stage::filter
                    : !std::isfinite(report.correction.error) ? Stage::correction
                                                              : Stage::second_filter;
  return outcome;
}

// Lengths as in step 3, and velocities that keep them. Below kSlow hair does not get visibly longer.
constexpr double kSlow = 1e-6;  // m/s
constexpr int kMostSweeps = 100;

void mend(MovingStrand& moving, const particles::Scratch& scratch) {
  correct_lengths(moving.strand, kLengthTolerance, kMostCorrections, moving.state.x, scratch);
  correct_velocities(moving.strand, moving.state.x, kSlow, kMostSweeps, moving.state.v, scratch);
}

}  // namespace

const StepMethod kPredictorCorrector{
    .step = predict_and_correct, .scratch = kPredictorCorrectorScratch, .mend = mend, .keeps_lengths = true};

}  // namespace hair
