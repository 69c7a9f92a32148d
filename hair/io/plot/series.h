// A series within a plot: its curve, its markers, its sample in a legend.
#pragma once

#include <string>
#include <vector>

#include "hair/io/plot/axes.h"
#include "hair/io/plot/figure.h"
#include "hair/io/plot/scale.h"
#include "hair/io/plot/xml.h"

namespace hair::plot {

struct Stroke {
  const char* colour;
  const char* dash = nullptr;  // none: a solid line
  const char* halo = nullptr;  // the colour of a wider line beneath, which separates it from the background
};

struct Place {
  const Box* box;
  const Scale* x;
  const Scale* y;
};

void draw_curve(XmlWriter& xml, const Series& series, const Stroke& stroke, const Place& place);

// Points outside the axes are drawn at the edge, as outlines. `shape` as in marker_path.
void draw_markers(XmlWriter& xml, const Series& series, int shape, const char* colour, const Place& place,
                  const std::string& x_title, const std::string& y_title);

// A marker with the tooltip `hover`; filled if `full`, otherwise an outline.
void draw_marker(XmlWriter& xml, double x, double y, int shape, const char* colour, bool full,
                 const std::string& hover);

void draw_sample(XmlWriter& xml, double x, double y, const Series& series, const Stroke& stroke, int shape);

}  // namespace hair::plot
