// STAFF ONLY. A right H6 as the lecture prints it, with its names: each solve's result is written as the
// force F^{n+1} that acts for dt/2.
#include "hair/predictor_corrector.h"

namespace hair {

StepReport predictor_corrector(const particles::Force& force, const particles::Particles& particles,
                               const Strand& strand, double dt, double tolerance, particles::State& state,
                               Scratch scratch) {
  StepReport report;
  auto solve_memory = scratch.leftCols(particles::kImplicitScratch);
  auto correction_memory = scratch.middleCols(particles::kImplicitScratch, kCorrectionScratch);
  auto v_half = scratch.col(particles::kImplicitScratch + kCorrectionScratch);
  auto F = scratch.col(particles::kImplicitScratch + kCorrectionScratch + 1);

  // (dt/2) F/m is the change of velocity: F = m dv / (dt/2).
  const auto implicit_force = [&](particles::SolveReport& solve) {
    solve = particles::solve_implicit(force, particles, state, dt / 2, dt, tolerance, F, solve_memory);
    for (int i = 0; i < particles.count(); ++i) F.segment<3>(3 * i) *= particles.mass[i] / (dt / 2);
  };
  const auto filtered = [&](Input v, Output to) {
    for (int i = 0; i < particles.count(); ++i)
      to.segment<3>(3 * i) = v.segment<3>(3 * i) + dt / 2 * F.segment<3>(3 * i) / particles.mass[i];
  };

  // 1. First pass: v^{n+1/2} = v^n + dt/2 F^{n+1}/m
  implicit_force(report.filter);
  filtered(state.v, v_half);

  // 2. x^{n+1} = x^n + dt v^{n+1/2}
  state.x = state.x + dt * v_half;

  // 3. x~^{n+1} = x^{n+1} + x^corr
  auto x_corr = F;  // F is not needed any more
  x_corr = -state.x;
  report.correction = correct_lengths(strand, kLengthTolerance, kMostCorrections, state.x, correction_memory);
  x_corr += state.x;

  // 4. v~^{n+1/2} = v^{n+1/2} + x^corr/dt
  state.v = v_half + x_corr / dt;

  // 5. v^{n+1} = v~^{n+1/2} + dt/2 F^{n+1}/m
  implicit_force(report.second_filter);
  filtered(state.v, v_half);
  state.v = v_half;
  return report;
}

}  // namespace hair
