// STAFF ONLY. Answers questions about a force (force_message.h) for the side that holds it.
#pragma once

#include <algorithm>
#include <vector>

#include "grader/wire/force_message.h"
#include "particles/force.h"
#include "solver/block_band.h"

namespace grader::inline wire {

// `question` has size_of_question(which, size) numbers; `which` is one of force_message.h.
inline void answer_about(const particles::Force& force, int which, int size,
                         const std::vector<double>& question, std::vector<double>& answer) {
  const auto vector = [&](int i) {
    return Eigen::Map<const Eigen::VectorXd>(question.data() + static_cast<std::ptrdiff_t>(i) * size, size);
  };
  if (which == kForceEnergy) {
    answer.assign(1, force.energy(vector(0)));
    return;
  }
  if (which == kForceBand) {
    answer.assign(size_of_band(size), 0.0);
    solver::BlockBand band(Eigen::Map<Eigen::MatrixXd>(answer.data() + 1, size, solver::BlockBand::kColumns));
    Eigen::MatrixXd work(size, particles::kBandScratch);
    const double* factors = question.data() + 2 * static_cast<std::ptrdiff_t>(size);
    answer[0] = force.add_band(vector(0), vector(1), factors[0], factors[1], band, work);
    return;
  }
  answer.assign(question.end() - size, question.end());
  Eigen::Map<Eigen::VectorXd> sum(answer.data(), size);
  if (which == kForceForce)
    force.add_force(vector(0), vector(1), sum);
  else if (which == kForceDfdx)
    force.add_dfdx(vector(0), vector(1), vector(2), sum);
  else
    force.add_dfdv(vector(0), vector(1), vector(2), sum);
}

// Adds the band of an answer; returns false if there is none.
inline bool add_answered_band(std::vector<double>& answer, solver::BlockBand& band) {
  const solver::BlockBand answered(
      Eigen::Map<Eigen::MatrixXd>(answer.data() + 1, 3 * band.rows(), solver::BlockBand::kColumns));
  for (int i = 0; i < band.rows(); ++i)
    for (int back = 0; back <= std::min(i, solver::BlockBand::kReach); ++back)
      band.block(i, back) += answered.block(i, back);
  return answer[0] != 0;
}

}  // namespace grader::wire
