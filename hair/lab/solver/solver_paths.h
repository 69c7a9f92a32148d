// The sections of the solver page with paths over a bowl, and what is said of a path.
#pragma once

#include <string>
#include <vector>

#include "hair/io/plot/columns.h"
#include "hair/io/plot/page.h"
#include "solver/study/bowl_path.h"

namespace hair::solver_lab {

// A section for each path.
std::vector<Section> path_sections(const std::vector<solver::study::BowlPath>& paths);

// Where it begins, and after how many steps it is at the bottom; the numbers decide.
std::string path_verdict(const solver::study::BowlPath& path);

// A row for each place of a path.
std::vector<Row> path_rows(const solver::study::BowlPath& path);

}  // namespace hair::solver_lab
