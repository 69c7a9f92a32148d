#include "hair/io/image/png_chunks.h"

#include <array>
#include <cstdint>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"

namespace hair {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
constexpr std::size_t kFrame = 12;  // bytes of a chunk beside its data: length, type, checksum

// Deflate makes at most 258 bytes of two bits.
constexpr std::size_t kMostInflation = 1032;

std::uint32_t big_endian(std::string_view bytes) {
  std::uint32_t number = 0;
  for (const char c : bytes.substr(0, 4)) number = number << 8 | static_cast<std::uint8_t>(c);
  return number;
}

// The CRC of annex D, of the polynomial 0xedb88320.
std::uint32_t checksum(std::string_view bytes) {
  static constexpr std::array<std::uint32_t, 256> table = [] {
    std::array<std::uint32_t, 256> sums{};
    for (std::uint32_t n = 0; n < 256; ++n) {
      std::uint32_t c = n;
      for (int bit = 0; bit < 8; ++bit) c = c & 1 ? 0xedb88320U ^ c >> 1 : c >> 1;
      sums[n] = c;
    }
    return sums;
  }();
  std::uint32_t c = 0xffffffffU;
  for (const char byte : bytes) c = table[(c ^ static_cast<std::uint8_t>(byte)) & 0xff] ^ c >> 8;
  return ~c;
}

// A chunk that a decoder must understand has a capital letter first (section 5.4). There are these four. An
// iPhone's "CgBI" is none of PNG: its data are packed in another way.
bool is_of_png(std::string_view type) {
  return (type[0] & 0x20) != 0 || type == "IHDR" || type == "PLTE" || type == "IDAT" || type == "IEND";
}

// Bytes of a pixel's samples, at most; 0 if there is no such kind.
std::size_t samples_of(int colour_type) {
  switch (colour_type) {
    case 0:
    case 3:
      return 1;
    case 2:
      return 3;
    case 4:
      return 2;
    case 6:
      return 4;
    default:
      return 0;
  }
}

}  // namespace

PngChunks read_png_chunks(std::string_view bytes, const std::string& name) {
  const auto fail = [&](const std::string& what) { throw BadInput(printable(name, 4096) + ": " + what); };
  if (bytes.substr(0, kSignature.size()) != kSignature) fail("is not a PNG picture; give a .png file");
  const std::size_t whole = bytes.size();
  bytes.remove_prefix(kSignature.size());

  PngChunks chunks;
  for (bool ended = false; !ended;) {
    if (bytes.size() < kFrame || bytes.size() - kFrame < big_endian(bytes)) {
      fail("is cut off; give the whole PNG file");
    }
    const std::size_t length = big_endian(bytes);
    const std::string_view type = bytes.substr(4, 4);
    const std::string_view data = bytes.substr(8, length);
    if (checksum(bytes.substr(4, 4 + length)) != big_endian(bytes.substr(8 + length))) {
      fail("is damaged (the checksum of its " + printable(type) + " is wrong); make it anew");
    }
    if (!is_of_png(type)) fail("has a " + printable(type) + ", which no PNG has; make it anew");
    if (type == "PLTE" && chunks.palette == 0) {
      chunks.palette = whole - bytes.size();
      chunks.palette_length = length;
    }
    bytes.remove_prefix(kFrame + length);

    const bool first = chunks.width == 0;
    if (first != (type == "IHDR") || (first && length != 13))
      fail("is not a PNG picture: its header is wrong");
    if (first) {
      const std::size_t width = big_endian(data), height = big_endian(data.substr(4));
      if (width < 1 || height < 1 || width > kMostSide || height > kMostSide ||
          width * height > kMostPixels) {
        fail("has " + std::to_string(width) + " x " + std::to_string(height) +
             " pixels; a picture here has 1 to 16384 a side and at most 64 million");
      }
      chunks.width = static_cast<int>(width);
      chunks.height = static_cast<int>(height);
      const std::size_t bits = static_cast<std::uint8_t>(data[8]), samples = samples_of(data[9]);
      if (samples == 0 || bits < 1 || bits > 16) fail("is not a PNG picture: its header is wrong");
      // Rows begin with a byte each; seven interlaced passes have at most a row for each of the picture's,
      // twice over, and a byte for what does not fill one.
      chunks.least = (width * samples * bits + 7) / 8 * height;
      chunks.most = chunks.least + 4 * height + 8 * (width + height);
    }
    if (type == "IDAT") chunks.data += data;
    ended = type == "IEND";
  }
  if (chunks.least / kMostInflation > chunks.data.size()) fail("has too few data for its size; make it anew");
  return chunks;
}

}  // namespace hair
