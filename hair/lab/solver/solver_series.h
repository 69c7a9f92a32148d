// The series of the solver study's figures, and the sections of its page with the convergence of conjugate
// gradients.
#pragma once

#include <string>

#include "hair/io/plot/figure.h"
#include "hair/io/plot/page.h"
#include "solver/study/solver_study.h"

namespace hair::solver_lab {

enum class Against { iterations, products, time };
enum class Measure { error, squared_residual };

// A value that is not finite becomes a failed point; an exact zero is drawn low enough to stand out.
Point point(double x, double y, std::string note = {});

Series series_of(const solver::study::History& history, const std::string& name, Against against,
                 Measure measure);

// The theory's curve for a measured history, down to the history's last error; with the look of another
// series.
Series bound_of(const solver::study::History& history, const std::string& name, int look);

std::string condition_name(const solver::study::History& history);

// A section for each family of systems.
Section conditions_section(const solver::study::SolverStudy& study);
Section strands_section(const solver::study::SolverStudy& study);

}  // namespace hair::solver_lab
