// The legend next to a plot: a name for each look.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "hair/io/plot/xml.h"

namespace hair::plot {

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
