// A picture: rows from the top down, three bytes a pixel (red, green, blue), encoded as sRGB, opaque.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hair {

struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;  // 3 width height

  const std::uint8_t* at(int x, int y) const {
    return pixels.data() + 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + x);
  }
  bool operator==(const Image&) const = default;
};

}  // namespace hair
