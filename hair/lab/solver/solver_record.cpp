#include "hair/lab/solver/solver_record.h"

#include <nlohmann/json.hpp>

namespace hair::solver_lab {

namespace {

using namespace solver::study;
using Json = nlohmann::ordered_json;  // what is not finite becomes null

Json json_of(const std::optional<int>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json json_of(const std::string& family, const History& history) {
  Json progress = Json::array();
  for (const Progress& one : history.progress)
    progress.push_back({{"iterations", one.iterations},
                        {"products", one.products},
                        {"error", one.error},
                        {"squared_residual", one.squared_residual},
                        {"claimed", one.claimed},
                        {"seconds", one.seconds}});
  return {{"family", family},      {"system", history.system},       {"solver", history.solver},
          {"unknowns", history.n}, {"condition", history.condition}, {"progress", progress}};
}

Json json_of(const ProductCost::Way& way) {
  return {{"multiplications", way.multiplications}, {"bytes", way.bytes}, {"seconds", way.seconds}};
}

}  // namespace

std::string solver_json(const SolverStudy& study, const std::string& machine, const std::string& left_out) {
  Json json = {{"program", "hairlab solver"},
               {"format", 2},
               {"quick", study.quick},
               {"machine", machine},
               {"seconds", study.cpu_seconds},
               {"left_out", left_out.empty() ? Json(nullptr) : Json(left_out)},
               {"most_iterations", study.most_iterations},
               {"convergence", Json::array()},
               {"direct", Json::array()}};
  const auto add = [&](const std::string& family, const std::vector<Compared>& systems) {
    for (const Compared& on : systems) {
      for (const History* history : on.histories()) json["convergence"].push_back(json_of(family, *history));
      if (on.direct)
        json["direct"].push_back({{"system", on.direct->system},
                                  {"solver", on.direct->solver},
                                  {"error", on.direct->error},
                                  {"squared_residual", on.direct->squared_residual},
                                  {"factor_seconds", on.direct->factor_seconds},
                                  {"solve_seconds", on.direct->solve_seconds}});
    }
  };
  add("condition numbers", study.conditions);
  add("clusters", study.clusters);
  add("strands", study.strands);
  add("linked strands", study.linked);
  for (const IterationsNeeded& one : study.needed)
    json["iterations"].push_back({{"condition", one.condition},
                                  {"conj_grad", json_of(one.conj_grad)},
                                  {"eigen", json_of(one.eigen)},
                                  {"clustered", json_of(one.clustered)},
                                  {"normal_equations", json_of(one.normal_equations)},
                                  {"bound", one.bound}});
  json["digits"] = Json::array();
  for (const DigitsLost& one : study.digits)
    json["digits"].push_back({{"condition", one.condition},
                              {"conj_grad", one.conj_grad},
                              {"iterations", one.iterations},
                              {"stopped", one.stopped},
                              {"cholesky", one.cholesky},
                              {"qr", one.qr},
                              {"pivoted_qr", one.pivoted_qr}});
  for (const ProductCost& one : study.products)
    json["products"].push_back(
        {{"unknowns", one.n}, {"formula", json_of(one.formula)}, {"table", json_of(one.table)}});
  return json.dump(2) + "\n";
}

}  // namespace hair::solver_lab
