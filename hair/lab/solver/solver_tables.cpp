#include "hair/lab/solver/solver_tables.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace hair::solver_lab {

namespace {

using namespace solver::study;

std::string count(const std::optional<int>& iterations) {
  return iterations ? std::to_string(*iterations) : "";
}

// How many of the 16 decimal digits of a double are right.
double digits_left(double error) {
  return std::max(0.0, -std::log10(error));
}

}  // namespace

Table table_of(const std::string& caption, const std::vector<Compared>& systems, Written written) {
  Table table = {
      caption,
      {"system", "unknowns", "condition number", "solver", "iterations", "products",
       "error in the A-norm, relative", "squared residual, relative", "as the solver says", "CPU time, s"},
      {}};
  for (const Compared& on : systems)
    for (const History* history : on.histories())
      for (const Progress& progress : history->progress)
        table.rows.push_back(
            {history->system, std::to_string(history->n), written(history->condition), history->solver,
             std::to_string(progress.iterations), std::to_string(progress.products), written(progress.error),
             written(progress.squared_residual),
             std::isnan(progress.claimed) ? "" : written(progress.claimed), written(progress.seconds)});
  return table;
}

Table table_of(const std::vector<DirectSolve>& direct, Written written) {
  Table table = {"A direct way on the same systems",
                 {"system", "solver", "error in the A-norm, relative", "squared residual, relative",
                  "CPU time of the factor, s", "of a solution, s"},
                 {}};
  for (const DirectSolve& one : direct)
    table.rows.push_back({one.system, one.solver, written(one.error), written(one.squared_residual),
                          written(one.factor_seconds), written(one.solve_seconds)});
  return table;
}

Table table_of(const std::vector<IterationsNeeded>& needed, Written written) {
  Table table = {
      "Iterations until the residual is 1e-8 of the right-hand side (empty: not within the limit, or the "
      "solver's residual or count is not true)",
      {"condition number", "ConjGrad", "Eigen's ConjugateGradient",
       "ConjGrad, " + std::to_string(kNeededClusters) + " clusters", "ConjGrad on A'A", "theory, at most"},
      {}};
  for (const IterationsNeeded& one : needed)
    table.rows.push_back({written(one.condition), count(one.conj_grad), count(one.eigen),
                          count(one.clustered), count(one.normal_equations), written(one.bound)});
  return table;
}

Table table_of(const std::vector<DigitsLost>& digits, Written written) {
  Table table = {"Relative errors of x, and digits that are left of 16",
                 {"condition number", "ConjGrad on A'A", "digits left", "iterations", "stopped",
                  "Cholesky of A'A", "digits left ", "QR of A", "digits left  ", "QR with pivots"},
                 {}};
  const auto left = [](double error) {
    return std::isfinite(error) ? to_text(std::round(10 * digits_left(error)) / 10) : "";
  };
  for (const DigitsLost& one : digits)
    table.rows.push_back({written(one.condition), written(one.conj_grad), left(one.conj_grad),
                          std::to_string(one.iterations), one.stopped ? "yes" : "", written(one.cholesky),
                          left(one.cholesky), written(one.qr), left(one.qr), written(one.pivoted_qr)});
  return table;
}

Table table_of(const std::vector<ProductCost>& products, Written written) {
  Table table = {"A product with a strand's matrix, by its formula and by the table of its entries",
                 {"unknowns", "formula: multiplications", "bytes", "CPU time, s", "table: multiplications",
                  "bytes of the table", "CPU time of the table, s", "times as long"},
                 {}};
  for (const ProductCost& one : products)
    table.rows.push_back({std::to_string(one.n), std::to_string(one.formula.multiplications),
                          std::to_string(one.formula.bytes), written(one.formula.seconds),
                          std::to_string(one.table.multiplications), std::to_string(one.table.bytes),
                          written(one.table.seconds), to_text(one.table.seconds / one.formula.seconds)});
  return table;
}

std::vector<NamedTable> solver_tables(const SolverStudy& study) {
  std::vector<Compared> all;
  std::vector<DirectSolve> direct;
  for (const std::vector<Compared>* family :
       {&study.conditions, &study.clusters, &study.strands, &study.linked})
    for (const Compared& on : *family) {
      all.push_back(on);
      if (on.direct) direct.push_back(*on.direct);
    }
  std::vector<NamedTable> tables = {{"convergence.csv", table_of("", all, to_exact_text)},
                                    {"direct.csv", table_of(direct, to_exact_text)},
                                    {"iterations.csv", table_of(study.needed, to_exact_text)},
                                    {"products.csv", table_of(study.products, to_exact_text)}};
  if (!study.digits.empty()) tables.push_back({"digits.csv", table_of(study.digits, to_exact_text)});
  return tables;
}

}  // namespace hair::solver_lab
