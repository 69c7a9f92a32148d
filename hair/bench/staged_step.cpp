#include "hair/bench/staged_step.h"

#include <chrono>

#include "hair/length_correction.h"
#include "hair/predictor_corrector.h"
#include "particles/implicit_euler.h"
#include "solver/timing.h"

namespace hair_bench {

namespace {

using particles::Input;
using particles::Output;

class TimedForce : public particles::Force {
 public:
  TimedForce(const particles::Force& force, Stages& stages) : force_(force), stages_(stages) {}
  double energy(Input x) const override { return force_.energy(x); }
  void add_force(Input x, Input v, Output f) const override {
    const timing::AddsTime watch(stages_.forces);
    force_.add_force(x, v, f);
  }
  void add_dfdx(Input x, Input v, Input dx, Output df) const override {
    const timing::AddsTime watch(stages_.products);
    force_.add_dfdx(x, v, dx, df);
  }
  void add_dfdv(Input x, Input v, Input dv, Output df) const override { force_.add_dfdv(x, v, dv, df); }
  bool add_band(Input x, Input v, double by_dfdx, double by_dfdv, solver::BlockBand& band,
                particles::Scratch work) const override {
    const timing::AddsTime watch(stages_.bands);
    return force_.add_band(x, v, by_dfdx, by_dfdv, band, work);
  }

 private:
  const particles::Force& force_;
  Stages& stages_;
};

}  // namespace

void staged_step(const particles::Force& force, const particles::Particles& particles,
                 const hair::Strand& strand, double h, particles::State& state, Eigen::MatrixXd& scratch,
                 Stages& stages) {
  const double before = stages.products + stages.forces + stages.bands;
  const TimedForce timed(force, stages);
  double solves = 0;
  {
    const timing::AddsTime watch(stages.all);
    auto solve_scratch = scratch.leftCols(particles::kImplicitScratch);
    auto correction_scratch = scratch.middleCols(particles::kImplicitScratch, hair::kCorrectionScratch);
    auto dv = scratch.col(hair::kPredictorCorrectorScratch - 1);
    auto predicted = scratch.col(hair::kPredictorCorrectorScratch - 2);
    const auto solve = [&] {
      const timing::AddsTime solve_watch(solves);
      solve_implicit(timed, particles, state, h / 2, h, particles::kSolveTolerance, dv, solve_scratch);
      state.v += dv;
    };
    solve();
    state.x += h * state.v;
    predicted = state.x;
    {
      const timing::AddsTime correction_watch(stages.correction);
      correct_lengths(strand, hair::kLengthTolerance, hair::kMostCorrections, state.x, correction_scratch);
    }
    state.v += (state.x - predicted) / h;
    solve();
  }
  stages.solver += solves - (stages.products + stages.forces + stages.bands - before);
}

}  // namespace hair_bench
