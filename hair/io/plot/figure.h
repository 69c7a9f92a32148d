// Figures as plain data, and as SVG: a text that a browser shows without scripts, fonts or files beside it.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace hair {

struct Axis {
  std::string title;  // with its unit: "error of the tip, m"
  bool logarithmic = true;
  std::optional<double> low = {}, high = {};  // none: what the points need
};

struct Point {
  double x = 0, y = 0;
  std::string note = {};  // what a pointer that rests on it reads, after the values: "h = 1/240 s"

  // Of a run that failed: drawn in a band at the figure's upper edge, its note in a list beneath the plot,
  // never dropped. y does not matter.
  bool failed = false;
};

// Points, joined in their order.
struct Series {
  std::string name;
  std::vector<Point> points;
  bool joined = true;
  bool marked = true;   // without markers it is a curve: of a theory, of a limit
  bool dashed = false;  // what was not measured

  // The colour and marker, counted from 0; none: those of its place in the figure's list. So a theory's curve
  // can look like what was measured, and a method the same in figures that list others.
  std::optional<int> look = {};
};

// A line y ~ x^slope in a logarithmic figure, to compare with: "order 2".
struct SlopeGuide {
  double slope = 1;
  std::string name;
};

// Series have colours and markers in their order, so that a method looks the same in all figures that list
// the same methods. Colours are told apart by those who see fewer of them, and never say anything that the
// marker does not.
struct Figure {
  std::string id;           // unique on its page, letters, digits and hyphens: "tip-error-against-time"
  std::string title;        // a line
  std::string description;  // what is seen in it, in a sentence or two, for those who can't see it
  Axis x, y;
  std::vector<Series> series = {};
  std::vector<SlopeGuide> guides = {};
};

// A map: a class for each cell of a grid.
struct CellMap {
  std::string id, title, description;
  Axis x, y;
  std::vector<double> xs, ys;        // the cells' middles, increasing
  std::vector<std::string> classes;  // "stable", "damped out", ...
  std::vector<int> cells;            // ys.size() rows of xs.size() classes, -1: not known
  std::vector<Series> limits;        // what theory says of its boundaries
};

// Text is escaped, whatever it holds. Throw std::invalid_argument for an id that is none, a value that is not
// finite where one must be, or not positive on a logarithmic axis, and for sizes that don't match.
std::string to_svg(const Figure& figure);
std::string to_svg(const CellMap& map);

}  // namespace hair
