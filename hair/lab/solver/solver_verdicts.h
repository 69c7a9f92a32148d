// The conclusions of the solver study, as sentences. The numbers decide each sentence, because the studied
// code may be wrong.
#pragma once

#include <string>
#include <vector>

#include "solver/study/solver_study.h"

namespace hair::solver_lab {

// Compares ConjGrad's errors with the theory's bound, as long as they are well above rounding.
std::string bound_verdict(const std::vector<solver::study::Compared>& systems);

// The times of ConjGrad, Eigen's conjugate gradients and the direct solver on the first and the last system.
std::string time_verdict(const std::vector<solver::study::Compared>& systems);

// Names systems for which ConjGrad took more iterations than the bound, compared with Eigen's.
std::string needed_verdict(const std::vector<solver::study::IterationsNeeded>& needed);

// Names systems for which the normal equations used all iterations; empty if there are none.
std::string stopped_verdict(const std::vector<solver::study::DigitsLost>& digits);

// "h = 10 ms" of "strand, h = 10 ms".
std::string step_of(const std::string& system);

}  // namespace hair::solver_lab
