// Text in figures. The font is unknown, so widths are estimated, with a margin.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hair/io/plot/xml.h"

namespace hair::plot {

inline constexpr double kSize = 13, kSmall = 12, kTitle = 16;  // letter sizes in pixels

double text_width(std::string_view text, double size);

// Breaks text at spaces into lines of at most this width, and cuts words that are longer.
std::vector<std::string> wrapped(std::string_view text, double width, double size);

struct Lettering {
  double size = kSize;
  const char* anchor = "start";  // "middle", "end"
  const char* weight = "normal";
};
void write(XmlWriter& xml, double x, double y, std::string_view text, const Lettering& lettering = {});

}  // namespace hair::plot
