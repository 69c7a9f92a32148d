// Pictures are written as PNG files by stb.
#pragma once

#include <string>

#include "hair/io/image/image.h"

namespace hair {

inline constexpr int kMostSide = 16384;  // pixels
inline constexpr std::size_t kMostPixels = 64'000'000;

// The same picture gives the same bytes, with the same zlib. Throws std::invalid_argument for a picture
// without pixels, larger than these bounds, or whose pixels are not three bytes each.
std::string encode_png(const Image& image);

}  // namespace hair
