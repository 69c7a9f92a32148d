// A stability study of a scene: its maps, its extreme cases, and their output.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "hair/io/plot/columns.h"
#include "hair/io/plot/figure.h"
#include "hair/lab/stability/extremes.h"
#include "hair/lab/stability/maps.h"
#include "hair/truth/problem.h"
#include "solver/not_implemented.h"

namespace hair {

inline constexpr int kMapSegments = 10;  // the limit for longer strands; stiff frequencies scale by theory

struct StabilitySettings {
  MapSettings maps;
  int strand = 0;                        // counted from 0
  std::optional<int> segments = {};      // none: the scene's, but at most kMapSegments
  std::vector<std::string> absent = {};  // exercises whose methods are left out
};

inline constexpr MapSettings kQuickMaps = {32, 32, 2000, 48};

// The frequencies that determine the maps, 1/s.
struct Frequencies {
  double along = 0, across = 0;  // the fastest of this hair
  double tension = 0;            // the fastest across it from tension alone
};

struct LeftOut {
  StudyMethod method;
  std::string why;
  std::optional<NotImplemented> stub = {};  // if its exercise is not written yet
};

struct StabilityReport {
  std::string scene;
  int segments = 0, scene_segments = 0;
  double length = 0, EA = 0, EI = 0;  // m, N, N m^2
  double mass = 0, drag = 0;          // kg, N s/m^2
  bool was_curved = false;
  Frequencies frequencies;
  std::vector<StabilityMap> maps;  // only complete ones
  std::vector<ExtremeRun> extremes;
  std::vector<LeftOut> left_out;
  bool interrupted = false;
  int maps_asked = 0;
  double cpu_seconds = 0;
};

// Reports the progress from time to time: "map 3 of 14: H6, stiffness: 120 runs".
using Tell = std::function<void(const std::string&)>;

// Throws BadInput for a scene without hair, or with hair that the study can't use. If interrupted, returns
// the finished parts.
StabilityReport study_stability(const Scene& scene, const StabilitySettings& settings,
                                const std::atomic<bool>& interrupted, const Tell& tell);

OrderedJson json_of(const StabilityReport& report);  // stability.json

// The rows of the CSV files and of the page's tables.
Row row_of_map(const StabilityMap& map);
std::vector<Row> limit_rows(const StabilityReport& report);  // boundaries.csv
Row row_of_extreme(const ExtremeRun& run);                   // extremes.csv
std::vector<Row> curve_rows(const StabilityReport& report);  // curves.csv: column by column

std::string percent(double part);    // "+1.5 %"
std::string cells(double distance);  // "-0.43"

// "H4, filtered; H4, full"
std::string names_of(const StabilityMap& map);

// A sentence on a limit that is no curve, over the whole map; and whether the map agrees.
std::string verdict(const StabilityMap& map, const Limit& limit);

Page page_of(const StabilityReport& report);

}  // namespace hair
