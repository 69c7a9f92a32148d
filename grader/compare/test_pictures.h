// STAFF ONLY. Draws synthetic pictures for tests.
#pragma once

#include <array>
#include <cmath>

#include "hair/io/image/image.h"

namespace grader::inline compare {

inline hair::Image even(const std::array<std::uint8_t, 3>& color, int width = 32, int height = 32) {
  hair::Image image{width, height, {}};
  for (int i = 0; i < width * height; ++i)
    image.pixels.insert(image.pixels.end(), color.begin(), color.end());
  return image;
}

inline hair::Image noise(int width, int height, unsigned seed) {
  hair::Image image{width, height, {}};
  unsigned state = seed * 2654435761U + 1;
  for (int i = 0; i < 3 * width * height; ++i)
    image.pixels.push_back(static_cast<std::uint8_t>((state = state * 1664525U + 1013904223U) >> 24));
  return image;
}

// Draws brown curves one pixel wide on near-black, placed from the left edge; moved right by `shift`.
inline hair::Image strands(int width, int height, int count, int shift = 0) {
  hair::Image image = even({12, 12, 16}, width, height);
  for (int strand = 0; strand < count; ++strand)
    for (int y = 0; y < height; ++y) {
      const double middle = (strand + 0.5) * 7 + 2 * std::sin(0.1 * y + strand) + shift;
      const int x = static_cast<int>(std::lround(middle));
      if (x < 0 || x >= width) continue;
      const std::size_t at =
          3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
      image.pixels[at] = 190;
      image.pixels[at + 1] = 130;
      image.pixels[at + 2] = 80;
    }
  return image;
}

}  // namespace grader::compare
