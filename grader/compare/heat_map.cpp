// STAFF ONLY. Colours an error by the table of heat colours.
#include "grader/compare/heat_map.h"

#include <algorithm>
#include <cmath>

namespace grader::inline compare {

HeatColor heat_color(double value) {
  const double at = std::clamp(value, 0.0, 1.0) * (kHeatColors.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(at), kHeatColors.size() - 2);
  const double share = at - static_cast<double>(below);
  HeatColor color{};
  for (std::size_t c = 0; c < 3; ++c)
    color[c] = static_cast<std::uint8_t>(
        std::lround((1 - share) * kHeatColors[below][c] + share * kHeatColors[below + 1][c]));
  return color;
}

hair::Image heat_map(const Plane& map) {
  hair::Image image{map.width, map.height, {}};
  image.pixels.reserve(3 * map.values.size());
  for (const float value : map.values)
    for (const std::uint8_t channel : heat_color(value)) image.pixels.push_back(channel);
  return image;
}

}  // namespace grader::compare
