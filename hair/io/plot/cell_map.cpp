#include <algorithm>
#include <array>
#include <stdexcept>

#include "hair/io/plot/axes.h"
#include "hair/io/plot/figure.h"
#include "hair/io/plot/lettering.h"
#include "hair/io/plot/look.h"
#include "hair/io/plot/page.h"
#include "hair/io/plot/series.h"

namespace hair {

namespace {

using namespace plot;

constexpr int kNotKnown = -1;

// A class has its own colour, lightness and hatching. The colours are near those of Okabe and Ito.
struct Hatching {
  const char* colour;
  const char* path;  // within a square of kTile pixels
  const char* stroke;
};

constexpr double kTile = 10;

constexpr Hatching kNotKnownHatching = {kPaper, "M2 5H8", kMiddle};
constexpr std::array<Hatching, 6> kHatchings = {{
    {"#cfe6f3", "", "none"},
    {"#f2e66b", "M4 5H6", "#4d4700"},
    {"#e69f00", "M-1 1L1 -1M0 10L10 0M9 11L11 9", "#6b3a00"},
    {"#7a2a12", "M-1 9L1 11M0 0L10 10M9 -1L11 1", "#a8583c"},
    {"#cc79a7", "M5 0V10", "#5c1d42"},
    {"#009e73", "M0 5H10", "#00402f"},
}};

const Hatching& hatching(int cell) {
  return cell == kNotKnown ? kNotKnownHatching : kHatchings[cell % kHatchings.size()];
}

std::string hatching_id(const CellMap& map, int cell) {
  return map.id + (cell == kNotKnown ? "-not-known" : "-class-" + std::to_string(cell));
}

void define_hatching(XmlWriter& xml, const CellMap& map, int cell) {
  const Hatching& look = hatching(cell);
  xml.open("pattern", {{"id", hatching_id(map, cell)},
                       {"patternUnits", "userSpaceOnUse"},
                       {"width", kTile},
                       {"height", kTile}});
  xml.empty("rect", {{"width", kTile}, {"height", kTile}, {"fill", look.colour}});
  xml.empty("path", {{"d", look.path}, {"stroke", look.stroke}, {"stroke-width", "1.2"}, {"fill", "none"}});
  xml.close();
}

std::string fill(const CellMap& map, int cell) {
  return "url(#" + hatching_id(map, cell) + ")";
}

std::string name_of(const CellMap& map, int cell) {
  return cell == kNotKnown ? "not known" : map.classes[cell];
}

void require(bool holds, const CellMap& map, const std::string& what) {
  if (!holds) throw std::invalid_argument("map \"" + map.id + "\": " + what);
}

void check(const CellMap& map) {
  check_id(map.id);
  require(!map.xs.empty() && !map.ys.empty(), map, "there are no cells; xs and ys must hold some");
  require(map.cells.size() == map.xs.size() * map.ys.size(), map,
          std::to_string(map.cells.size()) + " cells; " + std::to_string(map.ys.size()) + " rows of " +
              std::to_string(map.xs.size()) + " are needed");
  for (const int cell : map.cells)
    require(cell >= kNotKnown && cell < static_cast<int>(map.classes.size()), map,
            "a cell of class " + std::to_string(cell) + "; there are " + std::to_string(map.classes.size()) +
                " classes, and -1 for not known");
  for (const std::vector<double>* middles : {&map.xs, &map.ys})
    require(std::adjacent_find(middles->begin(), middles->end(), std::greater_equal<>()) == middles->end(),
            map, "the cells' middles must increase");
}

// Cells meet halfway between their middles, measured along the axis; outer cells reach as far outwards as
// inwards.
std::vector<double> edges(const std::vector<double>& middles, const Axis& axis, const std::string& what) {
  const Scale scale(axis, middles, 0, 0, 1, what);
  std::vector<double> places;
  for (const double middle : middles) places.push_back(scale.place(middle));
  const std::size_t n = places.size();
  const double first = n > 1 ? (places[1] - places[0]) / 2 : 0.5;
  const double last = n > 1 ? (places[n - 1] - places[n - 2]) / 2 : 0.5;
  std::vector<double> all = {scale.value_at(places[0] - first)};
  for (std::size_t i = 1; i < n; ++i) all.push_back(scale.value_at((places[i - 1] + places[i]) / 2));
  all.push_back(scale.value_at(places[n - 1] + last));
  return all;
}

// Equal neighbouring cells are one rectangle.
void draw_cells(XmlWriter& xml, const CellMap& map, const Scale& x, const Scale& y,
                const std::vector<double>& x_edges, const std::vector<double>& y_edges) {
  const std::size_t columns = map.xs.size();
  for (std::size_t row = 0; row < map.ys.size(); ++row)
    for (std::size_t begin = 0, end; begin < columns; begin = end) {
      const int* cells = &map.cells[row * columns];
      for (end = begin + 1; end < columns && cells[end] == cells[begin];) ++end;
      const double left = x.pixel(x_edges[begin]), right = x.pixel(x_edges[end]);
      const double top = y.pixel(y_edges[row + 1]), bottom = y.pixel(y_edges[row]);
      xml.open("rect", {{"class", "cells"},
                        {"x", left},
                        {"y", top},
                        {"width", right - left},
                        {"height", bottom - top},
                        {"fill", fill(map, cells[begin])}});
      const std::string range = end - begin == 1 ? to_text(map.xs[begin])
                                                 : to_text(map.xs[begin]) + " to " + to_text(map.xs[end - 1]);
      xml.leaf("title", {},
               name_of(map, cells[begin]) + "\n" + map.x.title + ": " + range + "\n" + map.y.title + ": " +
                   to_text(map.ys[row]));
      xml.close();
    }
}

Stroke stroke_of(const CellMap& map, std::size_t limit) {
  const bool dashed = limit > 0 || map.limits[limit].dashed;
  return {kText, dashed ? dashes(static_cast<int>(limit)) : nullptr, kPaper};
}

Legend legend_of(const CellMap& map) {
  std::vector<LegendEntry> entries;
  const auto add_class = [&](int cell) {
    entries.push_back({name_of(map, cell), [&map, cell](XmlWriter& xml, double x, double y) {
                         xml.empty("rect", {{"x", x - kSampleWide / 2},
                                            {"y", y - 9},
                                            {"width", kSampleWide},
                                            {"height", "18"},
                                            {"stroke", kText},
                                            {"stroke-width", "0.8"},
                                            {"fill", fill(map, cell)}});
                       }});
  };
  for (int cell = 0; cell < static_cast<int>(map.classes.size()); ++cell) add_class(cell);
  if (std::find(map.cells.begin(), map.cells.end(), kNotKnown) != map.cells.end()) add_class(kNotKnown);
  for (std::size_t i = 0; i < map.limits.size(); ++i)
    entries.push_back({map.limits[i].name, [&map, i](XmlWriter& xml, double x, double y) {
                         draw_sample(xml, x, y, map.limits[i], stroke_of(map, i), static_cast<int>(i));
                       }});
  return Legend(std::move(entries));
}

}  // namespace

std::string to_svg(const CellMap& map) {
  check(map);
  const std::string what = "map \"" + map.id + "\"";
  const Legend legend = legend_of(map);
  const Box box = {kLeftMargin, kTitleHeight, kFigureWidth - kLeftMargin - 2 * kGap - legend.width(),
                   kPlotHeight};
  const std::vector<double> x_edges = edges(map.xs, map.x, what), y_edges = edges(map.ys, map.y, what);
  const Scale x(map.x, {x_edges.front(), x_edges.back()}, 0, box.left, box.right(), what);
  const Scale y(map.y, {y_edges.front(), y_edges.back()}, 0, box.bottom(), box.top, what);

  XmlWriter xml;
  open_svg(xml, map.id, map.title, map.description,
           std::max(box.bottom() + kBelowPlot, box.top + legend.height()) + kBottomMargin);
  xml.open("defs");
  define_clip(xml, map.id + "-clip", box);
  for (int cell = kNotKnown; cell < static_cast<int>(map.classes.size()); ++cell)
    define_hatching(xml, map, cell);
  xml.close();
  // Crisp edges: adjacent rectangles leave no seam.
  xml.open("g", {{"clip-path", "url(#" + map.id + "-clip)"}});
  xml.open("g", {{"shape-rendering", "crispEdges"}});
  draw_cells(xml, map, x, y, x_edges, y_edges);
  xml.close();
  const Place place = {&box, &x, &y};
  for (std::size_t i = 0; i < map.limits.size(); ++i)
    if (map.limits[i].joined) draw_curve(xml, map.limits[i], stroke_of(map, i), place);
  xml.close();
  for (std::size_t i = 0; i < map.limits.size(); ++i)
    if (map.limits[i].marked)
      draw_markers(xml, map.limits[i], static_cast<int>(i), kText, place, map.x.title, map.y.title);
  draw_axes(xml, box, x, y, map.x.title, map.y.title);
  legend.draw(xml, box.right() + kGap, box.top);
  return xml.close().take();
}

}  // namespace hair
