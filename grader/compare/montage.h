// STAFF ONLY. Makes pictures for people who compare them: side by side, smaller, and errors as colours.
// Larger errors are lighter, so that a map is also readable on paper and without colour vision.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "grader/compare/plane.h"
#include "hair/io/image/image.h"

namespace grader::inline compare {

// A picture of this width, a tenth of those that are measured, is what students may see of what is far from
// the reference's.
inline constexpr int kCoarseWidth = 48, kCoarseHeight = 27;  // pixels

// Puts pictures from left to right with a dark line between them. There must be at least one picture, and all
// must have the same height, else it throws std::invalid_argument.
hair::Image side_by_side(const std::vector<hair::Image>& images);

// Makes a picture at most `width` pixels wide, with the same aspect ratio: each pixel is the mean of the
// pixels that it covers. A narrower picture stays unchanged.
hair::Image shrunk(const hair::Image& image, int width);

using HeatColor = std::array<std::uint8_t, 3>;  // red, green, blue

// This is Matplotlib's magma, as FLIP's authors show errors: evenly from 0 to 1, interpolated in encoded
// values.
inline constexpr std::array<HeatColor, 9> kHeatColors{{{0, 0, 4},
                                                       {28, 16, 68},
                                                       {79, 18, 123},
                                                       {129, 37, 129},
                                                       {181, 54, 122},
                                                       {229, 80, 100},
                                                       {251, 135, 97},
                                                       {254, 194, 135},
                                                       {252, 253, 191}}};

// Draws the map as a picture.
hair::Image heat_map(const Plane& map);

}  // namespace grader::compare
