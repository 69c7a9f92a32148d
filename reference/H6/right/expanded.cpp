// STAFF ONLY. A right H6 whose velocity after the correction is the whole way over h, (x~ - x^n) / h.
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
  const VectorXd x_old = state.x;
  StepReport report;

  // First pass
  report.filter = solve_implicit(force, particles, state, h / 2, h, tolerance, dv, solve_memory);
  state.v += dv;
  state.x += h * state.v;

  // Non-linear correction
  report.correction = correct_lengths(strand, kLengthTolerance, kMostCorrections, state.x, correction_memory);

  state.v = (state.x - x_old) / h;

  // Second pass
  report.second_filter = solve_implicit(force, particles, state, h / 2, h, tolerance, dv, solve_memory);
  state.v += dv;
  return report;
}

}  // namespace hair
