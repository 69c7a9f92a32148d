// STAFF ONLY. Errors as colours: larger errors are lighter, so that a map is also readable on paper and
// without colour vision.
#pragma once

#include <array>
#include <cstdint>

#include "grader/compare/plane.h"
#include "hair/io/image/image.h"

namespace grader::inline compare {

using HeatColor = std::array<std::uint8_t, 3>;  // red, green, blue

// Has night blue, violet, red, orange, pale yellow: evenly from 0 to 1, interpolated in encoded values.
inline constexpr std::array<HeatColor, 5> kHeatColors{
    {{8, 10, 34}, {84, 28, 116}, {196, 54, 78}, {248, 150, 48}, {255, 246, 198}}};

HeatColor heat_color(double value);  // clamped to 0..1

// Draws the map as a picture.
hair::Image heat_map(const Plane& map);

}  // namespace grader::compare
