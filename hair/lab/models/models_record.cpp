#include "hair/lab/models/models_record.h"

#include <nlohmann/json.hpp>

namespace hair::model_study {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const std::vector<FamilyRuns>& families) {
  Json list = Json::array();
  for (const FamilyRuns& family : families) {
    Json runs = Json::array();
    for (const ModelRun& run : family.runs)
      runs.push_back({{"elements", run.elements},
                      {"step", run.step},
                      {"trouble", run.trouble.empty() ? Json(nullptr) : Json(run.trouble)},
                      {"error", run.trouble.empty() ? Json(run.error) : Json(nullptr)},
                      {"seconds", run.seconds},
                      {"lengths", run.lengths}});
    list.push_back({{"family", family.family.id},
                    {"model", family.family.model},
                    {"method", row_of(family.family.method).id},
                    {"stretch_factor", family.family.stretch_factor},
                    {"twist_factor", family.family.twist_factor},
                    {"left_out", family.left_out.empty() ? Json(nullptr) : Json(family.left_out)},
                    {"runs", runs}});
  }
  return list;
}

}  // namespace

std::string models_json(const Comparison& comparison, const std::string& machine) {
  Json json = {{"program", "hairlab models"},
               {"format", 1},
               {"quick", comparison.quick},
               {"machine", machine},
               {"hairs", Json::array()}};
  for (const HairComparison& one : comparison.hairs)
    json["hairs"].push_back({{"hair", one.hair.id},
                             {"length", one.hair.spec.length},
                             {"seconds", kComparedTime},
                             {"uncertainty", one.uncertainty},
                             {"families", json_of(one.families)},
                             {"at_a_sixtieth", json_of(one.stiff)}});
  for (const HelixCost& one : comparison.helix_costs)
    json["helix_cost"].push_back(
        {{"elements", one.elements}, {"step", one.step}, {"mass_matrix", one.mass_matrix}});
  return json.dump(2) + "\n";
}

}  // namespace hair::model_study
