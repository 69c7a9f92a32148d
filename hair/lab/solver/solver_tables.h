// The solver study as tables: with all digits for CSV, rounded for the page.
#pragma once

#include <string>
#include <vector>

#include "hair/io/plot/page.h"
#include "solver/study/solver_study.h"

namespace hair::solver_lab {

// The format of numbers: to_text or to_exact_text.
using Written = std::string (*)(double);

Table table_of(const std::string& caption, const std::vector<solver::study::Compared>& systems,
               Written written);
Table table_of(const std::vector<solver::study::DirectSolve>& direct, Written written);
Table table_of(const std::vector<solver::study::IterationsNeeded>& needed, Written written);
Table table_of(const std::vector<solver::study::DigitsLost>& digits, Written written);
Table table_of(const std::vector<solver::study::ProductCost>& products, Written written);

struct NamedTable {
  std::string file;  // "convergence.csv"
  Table table;
};
std::vector<NamedTable> solver_tables(const solver::study::SolverStudy& study);

}  // namespace hair::solver_lab
