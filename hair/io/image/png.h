// Pictures as PNG files.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "hair/io/image/image.h"

namespace hair {

// The same picture gives the same bytes.
std::string encode_png(const Image& image);

// Throws BadInput, which begins with `name`: not a PNG, cut off, larger than 16384 pixels a side or 64
// million in all. What is transparent is put on black.
Image decode_png(std::string_view bytes, const std::string& name);

// Throws BadInput with the path, too, if it can't be read; write_file does for what can't be written.
Image read_png(const std::filesystem::path& file);
void write_png(const std::filesystem::path& file, const Image& image);

}  // namespace hair
