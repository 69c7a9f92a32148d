// A figure and a map that use every feature, and texts that break careless code.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "hair/io/plot/figure.h"

namespace hair::plot {

// Twelve methods of orders 1 to 4, some with failed runs, a bound, and slope guides.
inline Figure sample_figure() {
  Figure figure;
  figure.id = "sample";
  figure.title = "Error against time";
  figure.description = "Twelve methods; the higher the order, the steeper.";
  figure.x.title = "CPU time, s";
  figure.y.title = "error, m";
  for (int method = 0; method < 12; ++method) {
    Series series = {"method " + std::to_string(method), {}};
    for (int k = 0; k < 6; ++k) {
      Point point = {1e-4 * (1 + method) * std::pow(2, k), 0.01 * std::pow(2, -k * (1 + method % 4)),
                     "h = 1/" + std::to_string(100 << k) + " s"};
      point.failed = method < 3 && k < 2;
      series.points.push_back(point);
    }
    figure.series.push_back(series);
  }
  figure.series.push_back({"bound", {{1e-4, 0.1}, {1e-1, 1e-4}}, true, false, true});
  figure.guides = {{-1, "order 1"}, {-4, "order 4"}};
  return figure;
}

inline CellMap sample_map() {
  CellMap map;
  map.id = "sample-map";
  map.title = "Where it is stable";
  map.description = "Stable below a line, blown up above it.";
  map.x.title = "stiffness, N/m";
  map.y.title = "step, s";
  for (int i = 0; i < 12; ++i) map.xs.push_back(std::pow(10, -1 + 0.5 * i));
  for (int i = 0; i < 9; ++i) map.ys.push_back(std::pow(10, -5 + 0.5 * i));
  map.classes = {"stable", "damped out", "wrong", "blown up"};
  for (const double y : map.ys)
    for (const double x : map.xs) {
      const double w = y * std::sqrt(x);
      map.cells.push_back(w < 1e-3 ? 0 : w < 1e-2 ? 1 : w < 1e-1 ? 2 : w < 1 ? 3 : -1);
    }
  Series limit = {"theory", {}, true, false};
  Series measured = {"measured", {}};
  for (const double x : map.xs) {
    limit.points.push_back({x, 1e-3 / std::sqrt(x)});
    measured.points.push_back({x, 1.1e-3 / std::sqrt(x)});
  }
  map.limits = {limit, measured};
  return map;
}

inline std::vector<std::string> hostile_texts() {
  return {
      "</title><script>alert(1)</script>",
      "\" onload=\"alert(1)",
      "' onload='alert(1)",
      "a & b &amp; &nosuch; &#0;",
      "]]> <![CDATA[ <!-- -->",
      std::string("nul \0 bell \a escape \x1b[31m", 22),
      "carriage return \r and line\nfeed",
      "overlong \xC0\xAF, \xE0\x80\xAF, \xF0\x80\x80\xAF",
      "surrogate \xED\xA0\x80, beyond \xF4\x90\x80\x80, no character \xEF\xBF\xBF",
      "cut \xE2\x82",
      "lone \xBF\xFF\xFE",
      "C1 controls \xC2\x80\xC2\x9F",
      std::string(2000, 'W'),
      std::string(500, '\xFF'),
      "",
      "   ",
  };
}

}  // namespace hair::plot
