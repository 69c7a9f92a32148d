// What the solver's study found, in sentences that its numbers decide: the code that it studies may be wrong.
#pragma once

#include <string>
#include <vector>

#include "solver/study/solver_study.h"

namespace hair::solver_lab {

// Whether ConjGrad's errors are below the theory's bound, before they come near rounding.
std::string bound_verdict(const std::vector<solver::study::Compared>& systems);

// How many iterations ConjGrad took for each.
std::string clusters_verdict(const std::vector<solver::study::Compared>& clusters);

// How long ConjGrad, Eigen's and the direct way took on the first and the last system.
std::string time_verdict(const std::vector<solver::study::Compared>& systems);

// Whether ConjGrad took more iterations than the bound, and how Eigen's compares.
std::string needed_verdict(const std::vector<solver::study::IterationsNeeded>& needed);

// Where the normal equations were stopped; empty: nowhere.
std::string stopped_verdict(const std::vector<solver::study::DigitsLost>& digits);

// "h = 10 ms" of "strand, h = 10 ms".
std::string step_of(const std::string& system);

}  // namespace hair::solver_lab
