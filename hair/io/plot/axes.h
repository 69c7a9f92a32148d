// The frame of figures and maps: a box with ticks, labels and titles, within an SVG that has a description
// for screen readers.
#pragma once

#include <string>

#include "hair/io/plot/scale.h"
#include "hair/io/plot/xml.h"

namespace hair::plot {

// In pixels, y downwards.
struct Box {
  double left = 0, top = 0, width = 0, height = 0;

  double right() const { return left + width; }
  double bottom() const { return top + height; }
};

inline constexpr double kFigureWidth = 900;
inline constexpr double kPlotHeight = 400;
inline constexpr double kLeftMargin = 84;
inline constexpr double kGap = 18;        // between a plot and its neighbour
inline constexpr double kBelowPlot = 56;  // ticks, labels, title of the x axis
inline constexpr double kBottomMargin = 10;
inline constexpr double kTitleHeight = 36;

// Throws std::invalid_argument unless the id is a letter followed by letters, digits and hyphens.
void check_id(const std::string& id);

// Opens <svg> with title and description, for light and dark pages.
void open_svg(XmlWriter& xml, const std::string& id, const std::string& title, const std::string& description,
              double width, double height);
// The same as wide as all figures, with the title at the top.
void open_svg(XmlWriter& xml, const std::string& id, const std::string& title, const std::string& description,
              double height);

// "-" as a typographic minus, which is as long as a plus.
std::string with_minus(std::string text);

void draw_grid(XmlWriter& xml, const Box& box, const Scale& x, const Scale& y);
void draw_axes(XmlWriter& xml, const Box& box, const Scale& x, const Scale& y, const std::string& x_title,
               const std::string& y_title);

// Defines a clip path of the box with this id.
void define_clip(XmlWriter& xml, const std::string& id, const Box& box);

}  // namespace hair::plot
