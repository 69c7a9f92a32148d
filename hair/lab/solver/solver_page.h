// The solver's study as a page with figures.
#pragma once

#include <string>

#include "hair/io/plot/page.h"
#include "solver/study/solver_study.h"

namespace hair::solver_lab {

// `machine` is a line about what measured; `left_out` says why there are no normal equations, or is empty.
Page solver_page(const solver::study::SolverStudy& study, const std::string& machine,
                 const std::string& left_out);

}  // namespace hair::solver_lab
