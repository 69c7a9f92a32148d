// PNG files made by hand, for tests: kinds that encode_png does not write, and files that contradict
// themselves. Source: Portable Network Graphics (PNG) Specification, Second Edition, W3C 2003.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace hair::made {

inline std::string big_endian(std::uint32_t number) {
  return {static_cast<char>(number >> 24), static_cast<char>(number >> 16), static_cast<char>(number >> 8),
          static_cast<char>(number)};
}

// The CRC of a chunk's type and data, bit by bit.
inline std::uint32_t checksum(std::string_view bytes) {
  std::uint32_t c = 0xffffffffU;
  for (const char byte : bytes) {
    c ^= static_cast<std::uint8_t>(byte);
    for (int bit = 0; bit < 8; ++bit) c = (c & 1) != 0 ? 0xedb88320U ^ c >> 1 : c >> 1;
  }
  return ~c;
}

inline std::string chunk(const std::string& type, const std::string& data) {
  return big_endian(static_cast<std::uint32_t>(data.size())) + type + data +
         big_endian(checksum(type + data));
}

// zlib's data without compression.
inline std::string stored(const std::string& raw) {
  const auto size = static_cast<std::uint16_t>(raw.size());
  std::uint32_t a = 1, b = 0;
  for (const char byte : raw) {
    a = (a + static_cast<std::uint8_t>(byte)) % 65521;
    b = (b + a) % 65521;
  }
  const std::string lengths = {static_cast<char>(size), static_cast<char>(size >> 8),
                               static_cast<char>(~size), static_cast<char>(~size >> 8)};
  return std::string("\x78\x01\x01") + lengths + raw + big_endian(b << 16 | a);
}

struct Header {
  std::uint32_t width, height;
  char bits, kind;
  char interlaced = 0;
};

inline std::string png(const Header& header, const std::string& zlib, const std::string& before_data = "") {
  const std::string fields = big_endian(header.width) + big_endian(header.height) + header.bits +
                             header.kind + '\0' + '\0' + header.interlaced;
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", fields) + before_data + chunk("IDAT", zlib) + chunk("IEND", "");
}

}  // namespace hair::made
