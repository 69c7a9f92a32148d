#include <cmath>

#include "hair/lab/stability/report.h"

namespace hair {

namespace {

// A row of cells as a text, a digit for each: 0 stable, ..., 3 blown up.
std::vector<std::string> digits_of(const StabilityMap& map) {
  std::vector<std::string> digits(map.hs.size());
  for (std::size_t i = 0; i < map.grid.cells.size(); ++i)
    digits[i / map.xs.size()] += static_cast<char>('0' + map.grid.cells[i]);
  return digits;
}

Row row_of_left_out(const LeftOut& one) {
  return {{"method", "", one.method.id}, {"why", "", one.why}};
}

// One point of a map's curves.
Row row_of_point(const StabilityMap& map, std::size_t column) {
  const auto text = [](double h) { return std::isfinite(h) ? Value(h) : Value(); };
  const auto limit = [&](std::size_t i) {
    return i < map.limits.size() ? text(map.limits[i].h[column]) : Value();
  };
  return {{"method", "", map.method.id}, {"map", "", name_of(map.sweep)},
          {"x", "", map.xs[column]},     {"measured_h", "s", text(map.boundary[column])},
          {"theory_h", "s", limit(0)},   {"shown_by_steps_h", "s", limit(1)}};
}

}  // namespace

std::string percent(double part) {
  return printed("%+.1f %%", 100 * part);
}

std::string cells(double distance) {
  return printed("%+.2f", distance);
}

Row row_of_map(const StabilityMap& map) {
  std::vector<std::string> alike;
  for (const StudyMethod& method : map.alike) alike.push_back(method.id);
  const auto all = static_cast<double>(map.grid.cells.size());
  return {{"method", "", map.method.id, In::json},
          {"method", "", names_of(map), In::page},
          {"alike", "", alike, In::json},
          {"sweep", "", name_of(map.sweep), {"map"}},
          {"cells", "", map.grid.cells.size(), In::page},
          {"runs", "", map.grid.asked},
          {"cells / runs", "", all / static_cast<double>(map.grid.asked), In::page},
          {"steps", "", map.steps, {"steps a run"}},
          {"cpu_seconds", "", map.cpu_seconds, {"CPU time, s"}},
          {"x", "", map.xs, In::json},
          {"h", "s", map.hs, In::json},
          {"rows", "", digits_of(map), In::json},
          {"boundary", "s", map.boundary, In::json}};
}

std::vector<Row> limit_rows(const StabilityMap& map) {
  std::vector<Row> rows;
  for (const Limit& limit : map.limits) {
    const Distance& distance = limit.distance;
    const auto if_compared = [&](double number) { return distance.columns > 0 ? Value(number) : Value(); };
    const std::string words = verdict(map, limit);
    rows.push_back(
        {{"method", "", names_of(map), In::tables},
         {"map", "", name_of(map.sweep), In::tables},
         {"limit", "", limit.name + (words.empty() ? "" : ": " + words), In::tables},
         {"name", "", limit.name, In::json},
         {"of_run", "", limit.of_run, In::json},
         {"h", "s", limit.h, In::json},
         {"columns_compared", "", distance.columns, {"columns"}},
         {"median_cells", "", if_compared(distance.median_cells), {"median, cells", 1, cells}},
         {"worst_cells", "", if_compared(distance.worst_cells), {"largest, cells", 1, cells}},
         {"median_relative", "", if_compared(distance.median_relative), {"median, relative", 1, percent}},
         {"columns_beyond", "", distance.columns_beyond},
         {"beyond_cells",
          "",
          distance.columns_beyond > 0 ? Value(distance.beyond_cells) : Value(),
          {"by, cells", 1, cells}}});
  }
  return rows;
}

std::vector<Row> limit_rows(const StabilityReport& report) {
  std::vector<Row> rows;
  for (const StabilityMap& map : report.maps)
    for (Row& row : limit_rows(map)) rows.push_back(std::move(row));
  return rows;
}

Row row_of_extreme(const ExtremeRun& run) {
  return {{"case", "", run.extreme},
          {"method", "", run.method.id, In::files},
          {"method", "", run.method.name, In::page},
          {"h", "s", run.h},
          {"step_from", "", if_any(run.step_from)},
          {"became", "", fate_name(run.fate)},
          {"broke", "", if_any(run.blow_up)},
          {"steps", "", run.steps},
          {"largest_stretch", "", run.stretch},
          {"last_stretch", "", run.last_stretch, {"stretch at the end"}},
          {"most_energy", "", run.most_energy},
          {"last_energy", "", run.last_energy, {"energy at the end"}}};
}

std::vector<Row> curve_rows(const StabilityReport& report) {
  std::vector<Row> rows;
  for (const StabilityMap& map : report.maps)
    for (std::size_t i = 0; i < map.xs.size(); ++i) rows.push_back(row_of_point(map, i));
  return rows;
}

OrderedJson json_of(const StabilityReport& report) {
  OrderedJson maps = json_of(rows_of(report.maps, row_of_map)), classes = OrderedJson::array();
  for (std::size_t i = 0; i < report.maps.size(); ++i)
    maps[i]["limits"] = json_of(limit_rows(report.maps[i]));
  for (int i = 0; i < kFates; ++i) classes.push_back(fate_name(static_cast<Fate>(i)));
  return {{"scene", report.scene},
          {"ended", report.interrupted ? "interrupted" : "finished"},
          {"hair",
           {{"segments", report.segments},
            {"segments_of_scene", report.scene_segments},
            {"length", report.length},
            {"mass", report.mass},
            {"EA", report.EA},
            {"EI", report.EI},
            {"drag", report.drag}}},
          {"frequencies",
           {{"along", report.frequencies.along},
            {"across", report.frequencies.across},
            {"across_by_tension", report.frequencies.tension}}},
          {"classes", classes},
          {"maps_asked", report.maps_asked},
          {"maps", maps},
          {"extremes", json_of(rows_of(report.extremes, row_of_extreme))},
          {"left_out", json_of(rows_of(report.left_out, row_of_left_out))},
          {"cpu_seconds", report.cpu_seconds}};
}

}  // namespace hair
