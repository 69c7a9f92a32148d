// The solver's study as the series of its figures.
#pragma once

#include <string>

#include "hair/io/plot/figure.h"
#include "solver/study/solver_study.h"

namespace hair::solver_lab {

enum class Against { iterations, products, time };
enum class Measure { error, squared_residual };

// What is not finite is a failed point; what is exactly zero stands low enough to be seen as that.
Point point(double x, double y, std::string note = {});

Series series_of(const solver::study::History& history, const std::string& name, Against against,
                 Measure measure);

// The theory's curve for a measured one, down to where that ends; in the look of another series.
Series bound_of(const solver::study::History& history, const std::string& name, int look);

std::string condition_name(const solver::study::History& history);

}  // namespace hair::solver_lab
