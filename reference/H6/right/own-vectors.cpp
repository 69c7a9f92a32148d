// STAFF ONLY. A right H6 that takes the way over h for the impulse: x~ = x + h v(n+1/2) + x_corr, so (x~ - x)
// / h is v(n+1/2) + x_corr / h.
#include "hair/predictor_corrector.h"

#include <vector>

namespace hair {

StepReport predictor_corrector(const particles::Force& force, const particles::Particles& particles,
                               const Strand& strand, double h, double tolerance, particles::State& state,
                               Scratch scratch) {
  const auto size = static_cast<std::size_t>(state.x.size());
  std::vector<double> old(state.x.begin(), state.x.end()), change(size);
  Eigen::Map<Eigen::VectorXd> dv(change.data(), state.x.size());
  StepReport report;

  report.filter = particles::solve_implicit(force, particles, state, h / 2, h, tolerance, dv,
                                            scratch.rightCols(particles::kImplicitScratch));
  for (int k = 0; k < dv.size(); ++k) state.x[k] += h * (state.v[k] + dv[k]);

  report.correction = correct_lengths(strand, kLengthTolerance, kMostCorrections, state.x,
                                      scratch.rightCols(kCorrectionScratch));
  for (std::size_t k = 0; k < size; ++k) {
    const auto entry = static_cast<Eigen::Index>(k);
    // The root is not corrected, and keeps its velocity to the last bit.
    if (k >= 3) state.v[entry] = (state.x[entry] - old[k]) / h;
  }

  report.second_filter = particles::solve_implicit(force, particles, state, h / 2, h, tolerance, dv,
                                                   scratch.rightCols(particles::kImplicitScratch));
  for (std::size_t k = size; k-- > 0;) state.v[static_cast<Eigen::Index>(k)] += change[k];
  return report;
}

}  // namespace hair
