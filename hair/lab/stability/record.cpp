#include <cmath>
#include <nlohmann/json.hpp>

#include "hair/lab/stability/report.h"

namespace hair {

namespace {

using Json = nlohmann::ordered_json;

// JSON has no infinity: null says that there is none.
Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(number(value));
  return list;
}

const char* sweep_name(Swept sweep) {
  return sweep == Swept::stiffness ? "stiffness" : "drag";
}

// A row of cells as a text, a digit for each: 0 stable, ..., 3 blown up.
Json rows_of(const StabilityMap& map) {
  Json rows = Json::array();
  const std::size_t columns = map.xs.size();
  for (std::size_t row = 0; row < map.hs.size(); ++row) {
    std::string digits;
    for (std::size_t column = 0; column < columns; ++column)
      digits += static_cast<char>('0' + map.grid.cells[row * columns + column]);
    rows.push_back(digits);
  }
  return rows;
}

Json json_of(const StabilityMap& map) {
  Json alike = Json::array(), limits = Json::array();
  for (const StudyMethod& method : map.alike) alike.push_back(method.id);
  for (std::size_t i = 0; i < map.limits.size(); ++i) {
    const Limit& limit = map.limits[i];
    const Distance& distance = map.distances[i];
    limits.push_back({{"name", limit.name},
                      {"of_run", limit.of_run},
                      {"h", numbers(limit.h)},
                      {"columns_compared", distance.columns},
                      {"median_cells", distance.median_cells},
                      {"worst_cells", distance.worst_cells},
                      {"median_relative", distance.median_relative},
                      {"columns_beyond", distance.columns_beyond},
                      {"beyond_cells", distance.beyond_cells}});
  }
  return {{"method", map.method.id},
          {"alike", alike},
          {"sweep", sweep_name(map.sweep)},
          {"runs", map.grid.asked},
          {"steps", map.steps},
          {"x", numbers(map.xs)},
          {"h", numbers(map.hs)},
          {"rows", rows_of(map)},
          {"boundary", numbers(map.boundary)},
          {"limits", limits},
          {"cpu_seconds", map.cpu_seconds}};
}

Json json_of(const ExtremeRun& run) {
  return {{"case", run.extreme},
          {"method", run.method.id},
          {"h", run.h},
          {"step_from", run.step_from.empty() ? Json(nullptr) : Json(run.step_from)},
          {"became", fate_name(run.fate)},
          {"broke", run.blow_up.empty() ? Json(nullptr) : Json(run.blow_up)},
          {"steps", run.steps},
          {"largest_stretch", number(run.stretch)},
          {"last_stretch", number(run.last_stretch)},
          {"most_energy", number(run.most_energy)},
          {"last_energy", number(run.last_energy)}};
}

}  // namespace

std::string json_of(const StabilityReport& report) {
  Json maps = Json::array(), extremes = Json::array(), left_out = Json::array(), classes = Json::array();
  for (const StabilityMap& map : report.maps) maps.push_back(json_of(map));
  for (const ExtremeRun& run : report.extremes) extremes.push_back(json_of(run));
  for (const LeftOut& one : report.left_out)
    left_out.push_back({{"method", one.method.id}, {"why", one.why}});
  for (int i = 0; i < kFates; ++i) classes.push_back(fate_name(static_cast<Fate>(i)));
  const Json json = {{"program", "hairlab stability"},
                     {"identity", report.identity},
                     {"scene", report.scene},
                     {"ended", report.interrupted ? "interrupted" : "finished"},
                     {"quick", report.quick},
                     {"hair",
                      {{"segments", report.segments},
                       {"segments_of_scene", report.scene_segments},
                       {"length", report.length},
                       {"mass", report.mass},
                       {"EA", report.EA},
                       {"EI", report.EI},
                       {"GJ", report.GJ},
                       {"drag", report.drag}}},
                     {"frequencies",
                      {{"along", number(report.frequencies.along)},
                       {"across", number(report.frequencies.across)},
                       {"twist", number(report.frequencies.twist)},
                       {"across_by_tension", number(report.frequencies.tension)},
                       {"chain_with_full_tip", number(report.frequencies.chain)}}},
                     {"classes", classes},
                     {"maps_asked", report.maps_asked},
                     {"maps", maps},
                     {"extremes", extremes},
                     {"left_out", left_out},
                     {"cpu_seconds", report.cpu_seconds}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace hair
