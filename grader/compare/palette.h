// STAFF ONLY. Pictures in few colours, for pages: strands on a plain ground need no more, and take a quarter of
// the bytes. What is measured is measured before.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "hair/io/image/image.h"

namespace grader {

struct PalettePicture {
  int width = 0, height = 0;
  std::vector<std::array<std::uint8_t, 3>> colors;  // red, green, blue; at most 256
  std::vector<std::uint8_t> pixels;                 // which of them, row by row from the top
};

// At most so many colours, 1 to 256, else std::invalid_argument; the picture itself if it has no more. By median
// cut (P. Heckbert, Color image quantization for frame buffer display, SIGGRAPH 1982), but cut at the mean, and
// with a colour's weight the root of how often it occurs: the ground is most of a picture and has few colours.
PalettePicture in_few_colors(const hair::Image& image, std::size_t most);

// As a PNG file's bytes. The same picture gives the same bytes.
std::string encode_palette_png(const PalettePicture& picture);

}  // namespace grader
