// The page of `hairlab bowl`: the paths of ConjGrad and of the normal equations over a bowl, and a sentence
// on each path.
#pragma once

#include <string>
#include <vector>

#include "hair/io/plot/columns.h"
#include "hair/io/plot/page.h"
#include "solver/study/bowl_path.h"

namespace hair::bowl {

// A section for each path. `left_out`: why the path of the normal equations is missing, or empty.
Page bowl_page(const std::vector<solver::study::BowlPath>& paths, const std::string& left_out);

// A sentence on the path's begin and its steps to the bottom; the numbers decide.
std::string path_verdict(const solver::study::BowlPath& path);

// A row for each place of each path.
std::vector<Row> bowl_rows(const std::vector<solver::study::BowlPath>& paths);

}  // namespace hair::bowl
