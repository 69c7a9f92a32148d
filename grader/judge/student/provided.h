// STAFF ONLY. Provides functions of prerequisites to a student's process: the process calls them through the
// pipe, and holds no code of the reference. All arguments are hostile: their sizes are checked, and each call
// sends messages before it computes for long.
#pragma once

#include <string>
#include <vector>

#include "grader/wire/message.h"

namespace grader::inline judge {

// Holds a ConjGrad's arguments and result as the suite counted them, whatever the student reports.
struct ProvidedSolve {
  int most;  // is the step limit
  double epsilon, value;
};

// Answers one call with the reference's function: the exercise's id, then a request of its
// (grader/calls/call.h). The worker may call functions of the exercises `provided`. `served` answers for the
// force that the suite serves in this request, `callback` calls the worker about its own objects. Calls of
// ConjGrad are added to `solves`. Throws MalformedMessage for a call that makes no sense, and StoppedCall if
// `served` stops it.
MessageWriter provide(const std::vector<std::string>& provided, MessageReader call, const Products& served,
                      const Products& callback, std::vector<ProvidedSolve>& solves);

struct StoppedCall {};

}  // namespace grader::judge
