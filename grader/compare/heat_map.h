// STAFF ONLY. Errors as colours: larger errors are lighter, so that a map is also readable on paper and
// without colour vision.
#pragma once

#include <array>
#include <cstdint>

#include "grader/compare/plane.h"
#include "hair/io/image/image.h"

namespace grader::inline compare {

using HeatColor = std::array<std::uint8_t, 3>;  // red, green, blue

// Is Matplotlib's magma, as FLIP's authors show errors: evenly from 0 to 1, interpolated in encoded values.
inline constexpr std::array<HeatColor, 9> kHeatColors{{{0, 0, 4},
                                                       {28, 16, 68},
                                                       {79, 18, 123},
                                                       {129, 37, 129},
                                                       {181, 54, 122},
                                                       {229, 80, 100},
                                                       {251, 135, 97},
                                                       {254, 194, 135},
                                                       {252, 253, 191}}};

HeatColor heat_color(double value);  // clamped to 0..1

// Draws the map as a picture.
hair::Image heat_map(const Plane& map);

}  // namespace grader::compare
