// STAFF ONLY. Functions of prerequisites that the suite lends to a student's process: the suite's side of
// grader/wire/lent_functions.h. All arguments are hostile: lengths are checked, and no call computes for long
// without a message.
#pragma once

#include <string>
#include <vector>

#include "grader/wire/message.h"
#include "grader/wire/products.h"

namespace grader {

// What ConjGrad was called with, and what it returned: the suite's own numbers, whatever a report says.
struct LentSolve {
  int most;  // steps
  double epsilon, value;
};

// Answers one call with the reference's function. `lent` are the exercises whose functions the worker may call.
// `held` answers for the force that the suite serves in this request, `callback` asks the worker about its own
// objects. Calls of ConjGrad are added to `solves`. Throws MalformedMessage for a call that makes no sense, and StoppedLoan if `held` says stop.
MessageWriter lend(const std::vector<std::string>& lent, MessageReader call, const Products& held,
                   const Products& callback, std::vector<LentSolve>& solves);

struct StoppedLoan {};

}  // namespace grader
