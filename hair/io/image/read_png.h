// Reads PNG files, also hostile ones, by libpng.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "hair/io/image/png.h"

namespace hair {

// Throws BadInput with a message that begins with `name`, if the bytes are not a PNG, cut off, damaged, or
// larger than kMostSide a side or kMostPixels in total. Takes no more memory than a picture of its header's
// size, and that only if its data can hold as many pixels. Transparent pixels are composited over a grey, 0
// (black) to 255; colour spaces in the file are ignored.
Image decode_png(std::string_view bytes, const std::string& name, std::uint8_t background = 0);

// Throws BadInput with the path also if the file can't be read.
Image read_png(const std::filesystem::path& file, std::uint8_t background = 0);

}  // namespace hair
