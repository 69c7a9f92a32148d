// Figures as plain data, and as SVG text that a browser shows without scripts, fonts or other files.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace hair {

struct Axis {
  std::string title;  // with its unit: "error of the tip, m"
  bool logarithmic = true;
  std::optional<double> low = {}, high = {};  // none: fitted to the points
};

struct Point {
  double x = 0, y = 0;
  std::string note = {};  // the tooltip's text after the values: "h = 1/240 s"

  // A run that failed. The figure draws it in a band at its upper edge and lists its note beneath the plot. y
  // is ignored.
  bool failed = false;
};

// Points, joined in the given order.
struct Series {
  std::string name;
  std::vector<Point> points;
  bool joined = true;
  bool marked = true;   // without markers it is a curve: a theory or a limit
  bool dashed = false;  // for curves that were not measured

  // The index of colour and marker, from 0; none: the series' index in the figure. With it, a theory's curve
  // can look like its measurement, and a method looks the same in figures with different lists.
  std::optional<int> look = {};
};

// A reference line y ~ x^slope in a logarithmic figure: "order 2".
struct SlopeGuide {
  double slope = 1;
  std::string name;
};

// Series get colours and markers in their order, so that a method looks the same in all figures with the same
// list of methods. The colours suit colour-blind readers, and the markers carry the same information.
struct Figure {
  std::string id;           // unique on its page, letters, digits and hyphens: "tip-error-against-time"
  std::string title;        // a line
  std::string description;  // one or two sentences about the figure, for screen readers
  Axis x, y;
  std::vector<Series> series = {};
  std::vector<SlopeGuide> guides = {};
  bool same_unit =
      false;  // a unit is as long on both axes, which are linear: one of them goes on beyond its limits
};

// A map: a class for each cell of a grid.
struct CellMap {
  std::string id, title, description;
  Axis x, y;
  std::vector<double> xs, ys;        // the centres of the cells, increasing
  std::vector<std::string> classes;  // "stable", "damped out", ...
  std::vector<int> cells;            // ys.size() rows of xs.size() classes, -1: unknown
  std::vector<Series> limits;        // the theory's boundaries between classes
};

// All text is escaped. Throw std::invalid_argument for an invalid id, a value that is not finite where it
// must be, a value that is not positive on a logarithmic axis, and sizes that don't match.
std::string to_svg(const Figure& figure);
std::string to_svg(const CellMap& map);

}  // namespace hair
