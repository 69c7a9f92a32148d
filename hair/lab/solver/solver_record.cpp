#include "hair/lab/solver/solver_record.h"

#include <algorithm>
#include <cmath>

namespace hair::solver_lab {

using namespace solver::study;

namespace {

// The number of correct digits, out of a double's 16 decimal ones.
Value digits_left(double error) {
  return std::isfinite(error) ? Value(std::round(10 * std::max(0.0, -std::log10(error))) / 10) : Value();
}

Row row_of_history(const History& history) {
  return {{"system", "", history.system},
          {"unknowns", "", history.n},
          {"condition", "", history.condition, {"condition number"}},
          {"solver", "", history.solver}};
}

Row row_of_progress(const Progress& one) {
  return {{"iterations", "", one.iterations},
          {"products", "", one.products},
          {"error", "", one.error, {"error in the A-norm, relative"}},
          {"squared_residual", "", one.squared_residual, {"squared residual, relative"}},
          {"claimed", "", std::isnan(one.claimed) ? Value() : Value(one.claimed), {"as the solver says"}},
          {"seconds", "", one.seconds, {"CPU time, s"}}};
}

}  // namespace

Row row_of_needed(const IterationsNeeded& one) {
  return {{"condition", "", one.condition, {"condition number"}},
          {"conj_grad", "", one.conj_grad, {"ConjGrad"}},
          {"eigen", "", one.eigen, {"Eigen's ConjugateGradient"}},
          {"clustered", "", one.clustered, {"ConjGrad, " + std::to_string(kNeededClusters) + " clusters"}},
          {"normal_equations", "", one.normal_equations, {"ConjGrad on A'A"}},
          {"bound", "", one.bound, {"theory, at most"}}};
}

Row row_of_digits(const DigitsLost& one) {
  return {{"condition", "", one.condition, {"condition number"}},
          {"conj_grad", "", one.conj_grad, {"ConjGrad on A'A"}},
          {"conj_grad_digits", "", digits_left(one.conj_grad), {"digits left"}, In::tables},
          {"iterations", "", one.iterations},
          {"stopped", "", one.stopped},
          {"cholesky", "", one.cholesky, {"Cholesky of A'A"}},
          {"cholesky_digits", "", digits_left(one.cholesky), {"digits left"}, In::tables},
          {"qr", "", one.qr, {"QR of A"}},
          {"qr_digits", "", digits_left(one.qr), {"digits left"}, In::tables}};
}

std::vector<Row> convergence_rows(const std::vector<Compared>& systems) {
  std::vector<Row> rows;
  for (const Compared& on : systems)
    for (const History* history : on.histories())
      for (const Progress& progress : history->progress)
        rows.push_back(row_of_history(*history) + row_of_progress(progress));
  return rows;
}

std::vector<Row> direct_rows(const std::vector<Compared>& systems) {
  std::vector<Row> rows;
  for (const Compared& on : systems)
    if (on.direct)
      rows.push_back({{"system", "", on.direct->system},
                      {"solver", "", on.direct->solver},
                      {"error", "", on.direct->error, {"error in the A-norm, relative"}},
                      {"squared_residual", "", on.direct->squared_residual, {"squared residual, relative"}},
                      {"factor_seconds", "", on.direct->factor_seconds, {"CPU time of the factor, s"}},
                      {"solve_seconds", "", on.direct->solve_seconds, {"of a solution, s"}}});
  return rows;
}

OrderedJson solver_json(const SolverStudy& study, const std::string& left_out) {
  OrderedJson convergence = OrderedJson::array(), direct = OrderedJson::array();
  const auto add = [&](const char* family, const std::vector<Compared>& systems) {
    for (const Compared& on : systems)
      for (const History* history : on.histories()) {
        convergence.push_back(json_of(Row{{"family", "", family}} + row_of_history(*history)));
        convergence.back()["progress"] = json_of(rows_of(history->progress, row_of_progress));
      }
    for (const Row& row : direct_rows(systems)) direct.push_back(json_of(row));
  };
  add("condition numbers", study.conditions);
  add("strands", study.strands);
  return {{"format", 2},
          {"seconds", study.cpu_seconds},
          {"left_out", Value(if_any(left_out)).json()},
          {"most_iterations", study.most_iterations},
          {"convergence", convergence},
          {"direct", direct},
          {"iterations", json_of(rows_of(study.needed, row_of_needed))},
          {"digits", json_of(rows_of(study.digits, row_of_digits))}};
}

}  // namespace hair::solver_lab
