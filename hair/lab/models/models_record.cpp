#include "hair/lab/models/models_record.h"

#include <cmath>

namespace hair::model_study {

namespace {

OrderedJson list_of(const std::vector<FamilyRuns>& families) {
  OrderedJson list = OrderedJson::array();
  for (const FamilyRuns& one : families)
    list.push_back({{"family", one.family.id},
                    {"model", one.family.model},
                    {"method", row_of(one.family.method).id},
                    {"stretch_factor", one.family.stretch_factor},
                    {"twist_factor", one.family.twist_factor},
                    {"left_out", Value(if_any(one.left_out)).json()},
                    {"runs", json_of(rows_of(one.runs, row_of_run))}});
  return list;
}

}  // namespace

std::string step_text(double step) {
  const double inverse = std::round(1 / step);
  return std::abs(step * inverse - 1) < 1e-9 ? "1/" + to_text(inverse) : to_text(step);
}

Row row_of_run(const ModelRun& run) {
  return {{"elements", "", run.elements},
          {"step", "s", run.step, {.heading = "h, s", .written = step_text}},
          {"error", "m", run.trouble.empty() ? Value(run.error) : Value(), {"error, mm", 1e3}},
          {"seconds", "", run.seconds, {"ms for a second", 1e3}},
          {"trouble", "", if_any(run.trouble)},
          {"lengths", "", run.lengths, In::json}};
}

Row row_of_cost(const HelixCost& cost) {
  return {{"elements", "", cost.elements},
          {"step", "s", cost.step, {"helix_step", 1e6}},
          {"mass_matrix", "s", cost.mass_matrix, {"mass_matrix", 1e6}}};
}

std::vector<Row> model_rows(const Comparison& comparison) {
  std::vector<Row> rows;
  for (const HairComparison& one : comparison.hairs)
    for (const std::vector<FamilyRuns>* families : {&one.families, &one.stiff})
      for (const FamilyRuns& family : *families)
        for (const ModelRun& run : family.runs)
          rows.push_back(Row{{"hair", "", one.hair.id}, {"family", "", family.family.id}} + row_of_run(run));
  return rows;
}

std::vector<Row> length_rows(const Comparison& comparison) {
  std::vector<Row> rows;
  for (const HairComparison& one : comparison.hairs)
    for (const FamilyRuns& family : one.stiff)
      for (const ModelRun& run : family.runs)
        for (std::size_t k = 0; k < run.lengths.size(); ++k)
          rows.push_back({{"family", "", family.family.id},
                          {"elements", "", run.elements},
                          {"time", "s", static_cast<double>(k + 1) * run.step},
                          {"length_over_rest", "", run.lengths[k]}});
  return rows;
}

OrderedJson models_json(const Comparison& comparison) {
  OrderedJson json = {{"format", 1}, {"hairs", OrderedJson::array()}};
  for (const HairComparison& one : comparison.hairs)
    json["hairs"].push_back({{"hair", one.hair.id},
                             {"length", one.hair.spec.length},
                             {"seconds", kComparedTime},
                             {"uncertainty", one.uncertainty},
                             {"families", list_of(one.families)},
                             {"at_a_sixtieth", list_of(one.stiff)}});
  if (!comparison.helix_costs.empty())
    json["helix_cost"] = json_of(rows_of(comparison.helix_costs, row_of_cost));
  return json;
}

}  // namespace hair::model_study
