// The sections of the solver page with the convergence of conjugate gradients, one for each family of
// systems.
#pragma once

#include "hair/io/plot/page.h"
#include "solver/study/solver_study.h"

namespace hair::solver_lab {

Section conditions_section(const solver::study::SolverStudy& study);
Section clusters_section(const solver::study::SolverStudy& study);
Section strands_section(const solver::study::SolverStudy& study);
Section linked_section(const solver::study::SolverStudy& study);

}  // namespace hair::solver_lab
