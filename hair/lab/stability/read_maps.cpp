#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "hair/io/files/strict_json.h"
#include "hair/lab/stability/report.h"

namespace hair {

namespace {

constexpr double kMostInMaps = 1e300;
constexpr long kMostRuns = 1L << 52;

std::vector<double> read_numbers(const JsonValue& json) {
  std::vector<double> numbers;
  for (const JsonValue& one : json.items())
    numbers.push_back(one.is_null() ? std::numeric_limits<double>::infinity() : one.number(0, kMostInMaps));
  return numbers;
}

std::vector<int> read_cells(const JsonValue& rows, const StabilityMap& map) {
  std::vector<int> cells;
  for (const JsonValue& row : rows.items())
    for (const char digit : row.text()) cells.push_back(digit - '0');
  for (const int cell : cells)
    if (cell < 0 || cell >= kFates) rows.fail("has a class that there is not");
  if (map.xs.size() < 2 || map.hs.size() < 2 || cells.size() != map.xs.size() * map.hs.size())
    rows.fail("are not as many cells as \"x\" and \"h\" make");
  return cells;
}

StabilityMap read_map(const JsonValue& json) {
  StabilityMap map;
  map.method.id = json["method"].text();
  map.sweep = json["sweep"].word({"stiffness", "drag"}) == 0 ? Swept::stiffness : Swept::drag;
  map.xs = read_numbers(json["x"]);
  map.hs = read_numbers(json["h"]);
  map.steps = json["steps"].whole_number(1, kMostRuns);
  map.grid = {read_cells(json["rows"], map), json["runs"].whole_number(1, kMostRuns), true};
  map.boundary = boundary_of(map.grid, map.hs);
  for (const JsonValue& limit : json["limits"].items()) {
    limit.check_keys({"name", "of_run", "h", "columns_compared", "median_cells", "worst_cells",
                      "median_relative", "columns_beyond", "beyond_cells"});
    map.limits.push_back({limit["name"].text(), read_numbers(limit["h"]), limit["of_run"].boolean()});
    if (map.limits.back().h.size() != map.xs.size()) limit.fail("is not of as many columns as the map");
    map.distances.push_back(distance_of(map.boundary, map.limits.back().h, map.hs));
  }
  map.cpu_seconds = json["cpu_seconds"].number(0, kMostInMaps);
  return map;
}

}  // namespace

std::vector<StabilityMap> read_maps(const std::filesystem::path& file, const std::string& identity) {
  const nlohmann::json record = read_json(file);
  const std::string name = printable(file.string(), 4096);
  if (!record.is_object() || !record.contains("program") || record["program"] != "hairlab stability" ||
      !record.contains("identity") || !record.contains("maps"))
    throw BadInput(name + ": is not from hairlab stability; give the --out of an earlier study");
  if (record["identity"] != identity)
    throw BadInput(name +
                   ": can't be resumed: its hair, its settings or its program are others; "
                   "give another --out, or leave out --resume to replace it");
  std::vector<StabilityMap> maps;
  for (const JsonValue& map : JsonValue(record, file)["maps"].items()) {
    map.check_keys(
        {"method", "alike", "sweep", "runs", "steps", "x", "h", "rows", "boundary", "limits", "cpu_seconds"});
    StabilityMap one = read_map(map);
    if (std::any_of(maps.begin(), maps.end(), [&](const StabilityMap& other) {
          return other.method.id == one.method.id && other.sweep == one.sweep;
        }))
      map.fail("is there twice; leave out --resume to make all maps anew");
    maps.push_back(std::move(one));
  }
  return maps;
}

}  // namespace hair
