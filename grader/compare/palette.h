// STAFF ONLY. Pictures with few colours, for pages: they suffice for strands on a plain ground, and take a
// quarter of the bytes. All measurements use the full-colour pictures.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "hair/io/image/image.h"

namespace grader::inline compare {

struct PalettePicture {
  int width = 0, height = 0;
  std::vector<std::array<std::uint8_t, 3>> colors;  // red, green, blue; at most 256
  std::vector<std::uint8_t> pixels;                 // indices of colors, row by row from the top
};

// Reduces a picture to at most `most` colours, 1 to 256, else throws std::invalid_argument. A picture with
// few enough colours keeps them. All pixels in one cell of a grid of colours get the cell's mean; the cells
// are the smallest cubes that give so few colours.
PalettePicture in_few_colors(const hair::Image& image, std::size_t most);

// Writes a PNG file's bytes. The same picture gives the same bytes.
std::string encode_palette_png(const PalettePicture& picture);

}  // namespace grader::compare
