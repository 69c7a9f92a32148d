// STAFF ONLY. Errors as colours: the larger, the lighter, so that a map reads on paper and without colour
// vision, too.
#pragma once

#include <array>
#include <cstdint>

#include "grader/compare/plane.h"
#include "hair/io/image/image.h"

namespace grader {

using HeatColor = std::array<std::uint8_t, 3>;  // red, green, blue

// Night blue, violet, red, orange, pale yellow: evenly spaced from 0 to 1, mixed as they are encoded.
inline constexpr std::array<HeatColor, 5> kHeatColors{
    {{8, 10, 34}, {84, 28, 116}, {196, 54, 78}, {248, 150, 48}, {255, 246, 198}}};

HeatColor heat_color(double value);  // 0 to 1; what is outside is as its end

// The map as a picture.
hair::Image heat_map(const Plane& map);

}  // namespace grader
