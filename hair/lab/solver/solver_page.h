// The solver's study as a page with figures.
#pragma once

#include <string>

#include "hair/io/plot/page.h"
#include "solver/study/solver_study.h"

namespace hair::solver_lab {

// `machine` is a line about the machine; `left_out` is the reason why there are no normal equations, or
// empty.
Page solver_page(const solver::study::SolverStudy& study, const std::string& machine,
                 const std::string& left_out);

}  // namespace hair::solver_lab
