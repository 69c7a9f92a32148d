#include "hair/io/plot/figure.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hair/io/plot/axes.h"
#include "hair/io/plot/lettering.h"
#include "hair/io/plot/look.h"
#include "hair/io/plot/page.h"
#include "hair/io/plot/series.h"
#include "hair/io/plot/slope_guides.h"

namespace hair {

namespace {

using namespace plot;

constexpr double kRoom = 0.04;     // part of an axis, at its ends
constexpr double kFailedRow = 18;  // pixels
constexpr double kNoteLine = 16;

bool has_failed(const Series& series) {
  return std::any_of(series.points.begin(), series.points.end(), [](const Point& p) { return p.failed; });
}

std::vector<double> values(const Figure& figure, bool of_x) {
  std::vector<double> all;
  for (const Series& series : figure.series)
    for (const Point& point : series.points)
      if (of_x || !point.failed) all.push_back(of_x ? point.x : point.y);
  return all;
}

// The look of a series: by its index, or as requested.
struct Look {
  int shape;
  Stroke stroke;
};

std::vector<Look> looks_of(const Figure& figure) {
  std::vector<Look> looks;
  int dashed = 0, plain = 0;
  for (std::size_t i = 0; i < figure.series.size(); ++i) {
    const Series& series = figure.series[i];
    const int look = series.look.value_or(static_cast<int>(i));
    if (look < 0)
      throw std::invalid_argument("figure \"" + figure.id + "\": the series \"" + series.name +
                                  "\" looks like number " + std::to_string(look) + "; it must be >= 0");
    // Curves without markers differ in their dashes.
    const bool dash = series.dashed || (series.joined && !series.marked && plain++ > 0);
    looks.push_back({look, {colour(look), dash ? dashes(dashed++) : nullptr}});
  }
  return looks;
}

// The runs that failed, a row for each method, above the plot.
void draw_failed(XmlWriter& xml, const Figure& figure, const std::vector<Look>& looks, const Box& band,
                 const Scale& x) {
  xml.empty(
      "rect",
      {{"x", band.left}, {"y", band.top}, {"width", band.width}, {"height", band.height}, {"fill", kSoft}});
  write(xml, band.left - 9, band.top + kFailedRow / 2 + 4, "failed", {.anchor = "end"});
  double y = band.top + kFailedRow / 2;
  for (std::size_t i = 0; i < figure.series.size(); ++i) {
    const Series& series = figure.series[i];
    if (!has_failed(series)) continue;
    for (const Point& point : series.points)
      if (point.failed)
        draw_marker(
            xml, std::clamp(x.pixel(point.x), band.left, band.right()), y, looks[i].shape,
            looks[i].stroke.colour, false,
            series.name + "\n" + figure.x.title + ": " + to_text(point.x) + "\nfailed: " + point.note);
    y += kFailedRow;
  }
}

struct FailedNote {
  std::size_t series;
  std::vector<std::string> lines;
};

std::vector<FailedNote> failed_notes(const Figure& figure) {
  std::vector<FailedNote> notes;
  for (std::size_t i = 0; i < figure.series.size(); ++i) {
    if (!has_failed(figure.series[i])) continue;
    std::string text;
    for (const Point& point : figure.series[i].points)
      if (point.failed && !point.note.empty()) text += (text.empty() ? "" : "; ") + point.note;
    notes.push_back({i, wrapped(figure.series[i].name + ": " + (text.empty() ? "no note" : text),
                                kFigureWidth - kLeftMargin - 40, kSmall)});
  }
  return notes;
}

void draw_notes(XmlWriter& xml, const Figure& figure, const std::vector<FailedNote>& notes,
                const std::vector<Look>& looks, double top) {
  double y = top + kNoteLine;
  write(xml, kLeftMargin, y, "Failed:", {.size = kSmall, .weight = "bold"});
  for (const FailedNote& note : notes) {
    y += 4;
    draw_marker(xml, kLeftMargin + 8, y + kNoteLine - 4, looks[note.series].shape,
                looks[note.series].stroke.colour, false, figure.series[note.series].name);
    for (const std::string& line : note.lines)
      write(xml, kLeftMargin + 22, y += kNoteLine, line, {.size = kSmall});
  }
}

double height_of(const std::vector<FailedNote>& notes) {
  if (notes.empty()) return 0;
  double height = 2 * kNoteLine;
  for (const FailedNote& note : notes) height += 4 + kNoteLine * static_cast<double>(note.lines.size());
  return height;
}

// Spots on curves and at markers, close enough together that no label fits between.
std::vector<Spot> taken_spots(const Figure& figure, const Scale& x, const Scale& y) {
  constexpr double kApart = 10;
  std::vector<Spot> spots;
  for (const Series& series : figure.series) {
    bool joined = false;
    for (const Point& point : series.points) {
      if (!point.failed) {
        const Spot to = {x.pixel(point.x), y.pixel(point.y)};
        const Spot from = joined ? spots.back() : to;
        const int pieces =
            1 + static_cast<int>(std::min(1000.0, std::hypot(to.x - from.x, to.y - from.y) / kApart));
        for (int i = 1; i <= pieces; ++i)
          spots.push_back({from.x + (to.x - from.x) * i / pieces, from.y + (to.y - from.y) * i / pieces});
      }
      joined = !point.failed && series.joined;
    }
  }
  return spots;
}

void draw_guides(XmlWriter& xml, const Figure& figure, const Box& box, const Scale& x, const Scale& y) {
  if (figure.guides.empty()) return;
  if (!x.logarithmic() || !y.logarithmic())
    throw std::invalid_argument("figure \"" + figure.id +
                                "\": slope guides are for logarithmic axes; leave them out");
  for (const SlopeGuide& guide : figure.guides)
    if (!std::isfinite(guide.slope))
      throw std::invalid_argument("figure \"" + figure.id + "\": the slope of the guide \"" + guide.name +
                                  "\" is " + to_text(guide.slope) + "; it must be finite");
  const std::vector<PlacedGuide> placed = place_guides(figure.guides, box, x, y, taken_spots(figure, x, y));
  xml.open("g", {{"class", "guides"}, {"stroke", kMiddle}, {"stroke-width", "1.2"}});
  for (const PlacedGuide& guide : placed)
    xml.empty("line", {{"x1", guide.from.x}, {"y1", guide.from.y}, {"x2", guide.to.x}, {"y2", guide.to.y}});
  xml.close();
  xml.open("g", {{"fill", kQuiet}, {"font-style", "italic"}});
  for (std::size_t i = 0; i < placed.size(); ++i)
    write(xml, placed[i].label.x, placed[i].label.y, figure.guides[i].name, {.size = kSmall});
  xml.close();
}

// The axis with limits around the same middle, whose distance is so many pixels of this unit.
Axis widened(Axis axis, const Scale& scale, double pixels, double unit) {
  const double middle = (scale.low() + scale.high()) / 2;
  axis.low = middle - pixels * unit / 2;
  axis.high = middle + pixels * unit / 2;
  return axis;
}

Legend legend_of(const Figure& figure, const std::vector<Look>& looks) {
  std::vector<LegendEntry> entries;
  for (std::size_t i = 0; i < figure.series.size(); ++i)
    entries.push_back({figure.series[i].name, [&figure, &looks, i](XmlWriter& xml, double x, double y) {
                         draw_sample(xml, x, y, figure.series[i], looks[i].stroke, looks[i].shape);
                       }});
  return Legend(std::move(entries));
}

}  // namespace

std::string to_svg(const Figure& figure) {
  check_id(figure.id);
  const std::vector<Look> looks = looks_of(figure);
  const Legend legend = legend_of(figure, looks);
  const std::vector<FailedNote> notes = failed_notes(figure);

  const Box band = {kLeftMargin, kTitleHeight, kFigureWidth - kLeftMargin - 2 * kGap - legend.width(),
                    notes.empty() ? 0 : kFailedRow * static_cast<double>(notes.size()) + 4};
  const Box box = {band.left, band.bottom(), band.width, kPlotHeight};
  const std::string what = "figure \"" + figure.id + "\"";
  Scale x(figure.x, values(figure, true), kRoom, box.left, box.right(), what);
  Scale y(figure.y, values(figure, false), kRoom, box.bottom(), box.top, what);
  if (figure.same_unit) {
    if (x.logarithmic() || y.logarithmic())
      throw std::invalid_argument(what + ": a unit has no length on a logarithmic axis");
    const double unit = std::max((x.high() - x.low()) / box.width, (y.high() - y.low()) / box.height);
    x = Scale(widened(figure.x, x, box.width, unit), {}, 0, box.left, box.right(), what);
    y = Scale(widened(figure.y, y, box.height, unit), {}, 0, box.bottom(), box.top, what);
  }
  const double below = std::max(box.bottom() + kBelowPlot, box.top + legend.height());

  XmlWriter xml;
  open_svg(xml, figure.id, figure.title, figure.description, below + height_of(notes) + kBottomMargin);
  define_clip(xml, figure.id + "-clip", box);
  if (!notes.empty()) draw_failed(xml, figure, looks, band, x);
  draw_grid(xml, box, x, y);
  draw_guides(xml, figure, box, x, y);
  draw_axes(xml, box, x, y, figure.x.title, figure.y.title);
  const Place place = {&box, &x, &y};
  xml.open("g", {{"clip-path", "url(#" + figure.id + "-clip)"}});
  for (std::size_t i = 0; i < looks.size(); ++i)
    if (figure.series[i].joined) draw_curve(xml, figure.series[i], looks[i].stroke, place);
  xml.close();
  for (std::size_t i = 0; i < looks.size(); ++i)
    if (figure.series[i].marked)
      draw_markers(xml, figure.series[i], looks[i].shape, looks[i].stroke.colour, place, figure.x.title,
                   figure.y.title);
  legend.draw(xml, box.right() + kGap, box.top);
  if (!notes.empty()) draw_notes(xml, figure, notes, looks, below);
  return xml.close().take();
}

}  // namespace hair
