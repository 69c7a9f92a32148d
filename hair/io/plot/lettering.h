// Text in figures, and the legend beside a plot. The font is unknown, so widths are estimated with a margin.
#pragma once

#include <functional>
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

struct LegendEntry {
  std::string name;
  std::function<void(XmlWriter& xml, double x, double y)>
      draw_sample;  // kSampleWide, around the middle (x, y)
};

inline constexpr double kSampleWide = 34;

class Legend {
 public:
  explicit Legend(std::vector<LegendEntry> entries);

  double width() const { return width_; }  // 0 without entries
  double height() const;
  void draw(XmlWriter& xml, double left, double top) const;

 private:
  std::vector<LegendEntry> entries_;
  std::vector<std::vector<std::string>> names_;  // in lines
  double width_ = 0;
};

}  // namespace hair::plot
