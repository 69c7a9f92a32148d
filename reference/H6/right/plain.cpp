// STAFF ONLY. A right H6, straight from the lecture. The patches for H6 apply to it.
#include "hair/predictor_corrector.h"

namespace hair {

using Eigen::MatrixXd;
using Eigen::VectorXd;

StepReport predictor_corrector(const particles::Force& force, const particles::Particles& particles,
                               const Strand& strand, double h, double tolerance, particles::State& state,
                               Scratch /*scratch*/) {
  const int size = 3 * particles.count();
  MatrixXd solve_memory(size, particles::kImplicitScratch), correction_memory(size, kCorrectionScratch);
  VectorXd dv(size);
  StepReport report;

  // First pass
  report.filter = solve_implicit(force, particles, state, h / 2, h, tolerance, dv, solve_memory);
  state.v += dv;
  state.x += h * state.v;

  // Non-linear correction
  const VectorXd x_before = state.x;
  report.correction = correct_lengths(strand, kLengthTolerance, kMostCorrections, state.x, correction_memory);
  const VectorXd x_corr = state.x - x_before;

  // Impulse
  state.v += x_corr / h;

  // Second pass
  report.second_filter = solve_implicit(force, particles, state, h / 2, h, tolerance, dv, solve_memory);
  state.v += dv;
  return report;
}

}  // namespace hair
