// Pictures as PNG files.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "hair/io/image/image.h"

namespace hair {

// The same picture gives the same bytes.
std::string encode_png(const Image& image);

// Throws BadInput with a message that begins with `name`, if the bytes are not a PNG, cut off, or larger than
// 16384 pixels a side or 64 million pixels in total. Transparent pixels are composited over black.
Image decode_png(std::string_view bytes, const std::string& name);

// Reading also throws BadInput with the path if the file can't be read; writing throws as write_file does.
Image read_png(const std::filesystem::path& file);
void write_png(const std::filesystem::path& file, const Image& image);

}  // namespace hair
