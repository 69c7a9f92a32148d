// STAFF ONLY. What objects of lent functions share (grader/wire/lent_functions.h): lent_<id>.cpp defines an exercise's
// functions for a worker whose code needs them as a prerequisite.
#pragma once

#include <stdexcept>

#include "grader/wire/force_message.h"
#include "grader/wire/lent_functions.h"
#include "grader/worker/session.h"
#include "particles/force.h"

// Each object's own.
extern "C" __attribute__((visibility("default"))) grader::LentSession lent_session;

namespace grader {

// For functions that ask for nothing of the caller's.
inline void no_callback(int, std::vector<double>&, std::vector<double>&) {
  throw std::logic_error("the suite asks for what nobody holds");
}

// Answers questions about a force of the worker's own, in the form of grader/wire/force_message.h.
inline Session::Callback callback_of(const particles::Force& force) {
  return [&force](int which, std::vector<double>& question, std::vector<double>& answer) {
    const auto size = static_cast<Eigen::Index>(question.size()) / vectors_of_question(which);
    const auto vector = [&](int i) {
      return Eigen::Map<const Eigen::VectorXd>(question.data() + i * size, size);
    };
    if (which == kForceEnergy)
      answer.assign(1, 0.0);
    else
      answer.assign(question.end() - size, question.end());
    Eigen::Map<Eigen::VectorXd> result(answer.data(), static_cast<Eigen::Index>(answer.size()));
    if (which == kForceEnergy)
      result[0] = force.energy(vector(0));
    else if (which == kForceForce)
      force.add_force(vector(0), vector(1), result);
    else if (which == kForceDfdx)
      force.add_dfdx(vector(0), vector(1), vector(2), result);
    else
      force.add_dfdv(vector(0), vector(1), vector(2), result);
  };
}

}  // namespace grader
