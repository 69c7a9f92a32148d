// Checks a PNG's structure before it is decoded. Source: Portable Network Graphics (PNG) Specification,
// Second Edition, W3C 2003, sections 5, 10 and 11.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace hair {

inline constexpr int kMostSide = 16384;  // pixels
inline constexpr std::size_t kMostPixels = 64'000'000;

struct PngChunks {
  int width = 0, height = 0;
  std::string data;                 // all zlib data of the IDAT chunks
  std::size_t least = 0, most = 0;  // bounds of the inflated size, bytes
  std::size_t palette = 0;          // where the first PLTE chunk begins in the file; 0: there is none
  std::size_t palette_length = 0;   // bytes of its colours
};

// Throws BadInput with a message that begins with `name`: not a PNG, cut off, damaged (a checksum), too
// large, with a critical chunk that no PNG has.
PngChunks read_png_chunks(std::string_view bytes, const std::string& name);

}  // namespace hair
