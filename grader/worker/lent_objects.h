// STAFF ONLY. What objects of lent functions share (grader/wire/lent_functions.h): lent_<id>.cpp defines an exercise's
// functions for a worker whose code needs them as a prerequisite.
#pragma once

#include <limits>
#include <stdexcept>
#include <string>

#include "grader/wire/force_answer.h"
#include "grader/wire/lent_functions.h"
#include "grader/worker/session.h"
#include "particles/force.h"
#include "particles/vectors.h"

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
    answer_about(force, which, size_of_vectors(which, question.size()), question, answer);
  };
}

// Takes all the columns that the contract gives a function, and leaves nothing in them: what a caller keeps there is lost,
// as it may be with any function of that contract.
inline void spoil(particles::Scratch scratch, int columns) {
  if (scratch.cols() < columns)
    throw std::invalid_argument("scratch of " + std::to_string(scratch.cols()) + " columns; expected " +
                                std::to_string(columns));
  scratch.leftCols(columns).setConstant(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace grader
