// STAFF ONLY. A right H6 that keeps a table of its stages, and changes the caller's state at the end.
#include "hair/predictor_corrector.h"

#include <array>

namespace hair {
namespace {

using particles::State;

struct Stage {
  State state;
  particles::SolveReport solve;
};

// The state whose velocity has felt the force at the end of the step for half of it.
Stage filtered(const particles::Force& force, const particles::Particles& particles, const State& state,
               double h, double tolerance) {
  Eigen::MatrixXd memory(state.x.size(), particles::kImplicitScratch);
  Stage stage{state, {}};
  Eigen::VectorXd kick(state.v.size());
  stage.solve = particles::solve_implicit(force, particles, state, 0.5 * h, h, tolerance, kick, memory);
  stage.state.v = state.v + kick;
  return stage;
}

}  // namespace

StepReport predictor_corrector(const particles::Force& force, const particles::Particles& particles,
                               const Strand& strand, double h, double tolerance, State& state,
                               Scratch /*scratch*/) {
  std::array<State, 4> stages;  // predicted, moved, corrected, filtered
  const Stage first = filtered(force, particles, state, h, tolerance);
  stages[0] = first.state;
  stages[1] = {stages[0].x + h * stages[0].v, stages[0].v};
  stages[2] = stages[1];
  Eigen::MatrixXd memory(state.x.size(), kCorrectionScratch);
  const CorrectionReport correction =
      correct_lengths(strand, kLengthTolerance, kMostCorrections, stages[2].x, memory);
  stages[2].v = stages[1].v + (stages[2].x - stages[1].x) / h;
  const Stage second = filtered(force, particles, stages[2], h, tolerance);
  stages[3] = second.state;
  state = stages[3];
  return {first.solve, correction, second.solve};
}

}  // namespace hair
