// STAFF ONLY. Functions of prerequisites that the suite provides to a student's process: the process calls
// them through the pipe, and holds no code of the reference. All arguments are hostile: their sizes are
// checked, and no call computes for long without a message.
#pragma once

#include <string>
#include <vector>

#include "grader/wire/message.h"
#include "grader/wire/products.h"

namespace grader::inline judge {

// The arguments and the result of a ConjGrad: the suite's own numbers, whatever a report says.
struct ProvidedSolve {
  int most;  // steps
  double epsilon, value;
};

// Answers one call with the reference's function: the exercise's id, then a request of its
// (grader/calls/call.h). `provided` are the exercises whose functions the worker may call. `served` answers
// for the force that the suite serves in this request, `callback` asks the worker about its own objects.
// Calls of ConjGrad are added to `solves`. Throws MalformedMessage for a call that makes no sense, and
// StoppedCall if `served` says stop.
MessageWriter provide(const std::vector<std::string>& provided, MessageReader call, const Products& served,
                      const Products& callback, std::vector<ProvidedSolve>& solves);

struct StoppedCall {};

}  // namespace grader::judge
