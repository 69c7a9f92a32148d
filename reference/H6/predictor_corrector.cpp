// STAFF ONLY. H6: the lecture's predictor-corrector, step by step as it numbers them.

#include "hair/predictor_corrector.h"

namespace hair {

StepReport predictor_corrector(const particles::Force& force, const particles::Particles& particles,
                               const Strand& strand, double h, double tolerance, particles::State& state,
                               Scratch scratch) {
  auto solve_scratch = scratch.leftCols(particles::kImplicitScratch);
  auto correction_scratch = scratch.middleCols(particles::kImplicitScratch, kCorrectionScratch);
  auto dv = scratch.col(particles::kImplicitScratch + kCorrectionScratch);
  auto predicted = scratch.col(particles::kImplicitScratch + kCorrectionScratch + 1);
  StepReport report;

  // 1. v(n+1/2) = v(n) + dv
  report.filter = particles::solve_implicit(force, particles, state, h / 2, h, tolerance, dv, solve_scratch);
  state.v += dv;
  // 2. x(n+1) = x(n) + h v(n+1/2)
  state.x += h * state.v;
  // 3. x~ = x(n+1) + x_corr
  predicted = state.x;
  report.correction =
      correct_lengths(strand, kLengthTolerance, kMostCorrections, state.x, correction_scratch);
  // 4. v~ = v(n+1/2) + x_corr / h
  state.v += (state.x - predicted) / h;
  // 5. v(n+1) = v~ + dv, the force and its derivatives at x~ and v~
  report.second_filter =
      particles::solve_implicit(force, particles, state, h / 2, h, tolerance, dv, solve_scratch);
  state.v += dv;
  return report;
}

}  // namespace hair
