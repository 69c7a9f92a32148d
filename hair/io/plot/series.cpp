#include "hair/io/plot/series.h"

#include <algorithm>
#include <cmath>

#include "hair/io/plot/lettering.h"
#include "hair/io/plot/look.h"
#include "hair/io/plot/page.h"

namespace hair::plot {

namespace {

constexpr double kMarkerRadius = 4.5, kLineWidth = 1.8;

void draw_path(XmlWriter& xml, const std::string& path, const Stroke& stroke) {
  const auto draw = [&](const char* colour, double width, const char* dash) {
    xml.empty("path", {{"d", path},
                       {"fill", "none"},
                       {"stroke", colour},
                       {"stroke-width", width},
                       {"stroke-dasharray", dash},
                       {"stroke-linejoin", "round"}});
  };
  if (stroke.halo) draw(stroke.halo, kLineWidth + 3, "none");
  draw(stroke.colour, kLineWidth, stroke.dash ? stroke.dash : "none");
}

}  // namespace

void draw_curve(XmlWriter& xml, const Series& series, const Stroke& stroke, const Place& place) {
  std::string path;
  bool down = false;  // a failed run interrupts the curve
  for (const Point& point : series.points) {
    if (!point.failed)
      path += (down ? "L" : "M") + pixels(place.x->pixel(point.x)) + " " + pixels(place.y->pixel(point.y));
    down = !point.failed;
  }
  if (!path.empty()) draw_path(xml, path, stroke);
}

void draw_marker(XmlWriter& xml, double x, double y, int shape, const char* colour, bool full,
                 const std::string& hover) {
  // An empty marker reacts to the pointer inside, too.
  xml.open("path", {{"class", "point"},
                    {"transform", "translate(" + pixels(x) + " " + pixels(y) + ")"},
                    {"d", marker_path(shape, full ? kMarkerRadius : kMarkerRadius - 0.5)},
                    {"fill", full ? colour : kPaper},
                    {"stroke", full ? kPaper : colour},
                    {"stroke-width", full ? "0.8" : "1.4"}});
  xml.leaf("title", {}, hover).close();
}

void draw_markers(XmlWriter& xml, const Series& series, int shape, const char* colour, const Place& place,
                  const std::string& x_title, const std::string& y_title) {
  for (const Point& point : series.points) {
    if (point.failed) continue;
    const bool inside = place.x->contains(point.x) && place.y->contains(point.y);
    std::string hover =
        series.name + "\n" + x_title + ": " + to_text(point.x) + "\n" + y_title + ": " + to_text(point.y);
    if (!point.note.empty()) hover += "\n" + point.note;
    if (!inside) hover += "\n(beyond the axes)";
    const double x = std::clamp(place.x->pixel(point.x), place.box->left, place.box->right());
    const double y = std::clamp(place.y->pixel(point.y), place.box->top, place.box->bottom());
    draw_marker(xml, x, y, shape, colour, inside, hover);
  }
}

void draw_sample(XmlWriter& xml, double x, double y, const Series& series, const Stroke& stroke, int shape) {
  if (series.joined || !series.marked)
    draw_path(xml,
              "M" + pixels(x - kSampleWide / 2) + " " + pixels(y) + "L" + pixels(x + kSampleWide / 2) + " " +
                  pixels(y),
              stroke);
  if (series.marked) draw_marker(xml, x, y, shape, stroke.colour, true, series.name);
}

}  // namespace hair::plot
