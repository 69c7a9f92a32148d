// A PNG's structure, looked at before anything is taken from it. Source: Portable Network Graphics (PNG)
// Specification, Second Edition, W3C 2003, sections 5, 10 and 11.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace hair {

inline constexpr int kMostSide = 16384;  // pixels
inline constexpr std::size_t kMostPixels = 64'000'000;

struct PngChunks {
  int width = 0, height = 0;
  std::string data;                 // zlib's: all that the IDAT chunks hold
  std::size_t least = 0, most = 0;  // bytes that they inflate to
};

// Throws BadInput, which begins with `name`: not a PNG, cut off, damaged (a checksum), too large.
PngChunks read_png_chunks(std::string_view bytes, const std::string& name);

}  // namespace hair
