// Text in figures. What a font makes of it is not known, so widths are guessed, rather too large.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hair/io/plot/xml.h"

namespace hair::plot {

inline constexpr double kSize = 13, kSmall = 12, kTitle = 16;  // of letters, in pixels

double text_width(std::string_view text, double size);

// Lines that are no wider, broken at spaces; a word that is too long alone is cut.
std::vector<std::string> wrapped(std::string_view text, double width, double size);

struct Lettering {
  double size = kSize;
  const char* anchor = "start";  // "middle", "end"
  const char* weight = "normal";
};
void write(XmlWriter& xml, double x, double y, std::string_view text, const Lettering& lettering = {});

}  // namespace hair::plot
