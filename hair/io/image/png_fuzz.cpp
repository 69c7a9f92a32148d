// Hostile bytes as a PNG file, unchanged and with repaired checksums. An accepted picture can be written, and
// reading it again gives the same picture.
#include <cstdint>

#include "hair/io/files/bad_input.h"
#include "hair/io/fuzz/fuzz.h"
#include "hair/io/image/made_png.h"
#include "hair/io/image/read_png.h"

namespace {

using hair::Image, hair::made::Header;

// Larger pictures are left out: they take time, and test nothing else.
constexpr std::uint64_t kMostPixelsTried = 4096;

std::uint64_t big_endian(std::string_view bytes) {
  std::uint64_t number = 0;
  for (const char c : bytes) number = number << 8 | static_cast<std::uint8_t>(c);
  return number;
}

// The size in the header, which is the first chunk; 0 without a header.
struct Size {
  std::uint64_t width = 0, height = 0;
};

Size size_of(std::string_view bytes) {
  if (bytes.size() < 24) return {};
  return {big_endian(bytes.substr(16, 4)), big_endian(bytes.substr(20, 4))};
}

// The same chunks with right checksums, which a change of one byte never makes.
std::string repaired(std::string_view bytes) {
  std::string all(bytes);
  for (std::size_t at = 8; all.size() >= at + 12;) {
    const std::size_t length = big_endian(std::string_view(all).substr(at, 4));
    if (all.size() - at - 12 < length) break;
    const std::string_view summed(all.data() + at + 4, 4 + length);
    all.replace(at + 8 + length, 4, hair::made::big_endian(hair::made::checksum(summed)));
    at += 12 + length;
  }
  return all;
}

// Leaves its numbers on the stack, so that a decoder that reads uninitialised memory finds them.
[[gnu::noinline]] void scribble(char number) {
  volatile char left[100'000];
  for (volatile char& byte : left) byte = number;
}

Image decoded(std::string_view bytes) {
  scribble(0x11);
  const Image image = hair::decode_png(bytes, "a.png");
  scribble(0x66);
  fuzz::expect(hair::decode_png(bytes, "a.png") == image, "the same bytes are the same picture");
  return image;
}

void check(const Image& image, const Size& size) {
  fuzz::expect(static_cast<std::uint64_t>(image.width) == size.width &&
                   static_cast<std::uint64_t>(image.height) == size.height,
               "its size is its header's");
  fuzz::expect(image.pixels.size() == 3 * static_cast<std::size_t>(image.width * image.height),
               "each pixel has three bytes");
  fuzz::expect(hair::decode_png(hair::encode_png(image), "b.png") == image,
               "a picture that is written is read as it was");
}

void try_png(std::string_view bytes) {
  try {
    const Size size = size_of(bytes);
    if (size.width * size.height > kMostPixelsTried) return;
    check(decoded(bytes), size);
  } catch (const hair::BadInput& error) {
    fuzz::expect_readable(error.what());
    fuzz::expect(std::string_view(error.what()).starts_with("a.png: "), "a message begins with the name");
  }
}

std::string rows(std::size_t height, std::size_t bytes) {
  std::string all;
  for (std::size_t i = 0; i < height; ++i)
    all += static_cast<char>(i % 5) + std::string(bytes, static_cast<char>(37 * i));
  return all;
}

}  // namespace

void fuzz::try_input(std::string_view bytes) {
  try_png(bytes);
  try_png(repaired(bytes));
}

// Pictures of 3 and 4 bytes a pixel, the memory of libpng and zlib, and chunks. Writing takes a table of
// 16384 pointers, each to a short list.
std::size_t fuzz::most_memory(std::size_t input) {
  return 1'500'000 + 10 * input;
}

std::vector<std::string> fuzz::seeds() {
  using hair::made::chunk, hair::made::png, hair::made::stored;
  const std::string palette = chunk("PLTE", std::string("\1\2\3\4\5\6\7\10\11\12\13\14", 12));
  std::vector<std::string> all;
  for (const char bits : {1, 2, 4, 8, 16}) {
    const auto row = [&](std::size_t samples) {
      return (5 * samples * static_cast<std::size_t>(bits) + 7) / 8;
    };
    const auto size = static_cast<std::uint32_t>(5);
    all.push_back(png({size, 5, bits, 0}, stored(rows(5, row(1)))));
    all.push_back(png({size, 5, bits, 0}, stored(rows(5, row(1))), chunk("tRNS", std::string("\0\1", 2))));
    if (bits <= 8)
      all.push_back(png({size, 5, bits, 3}, stored(rows(5, row(1))), palette + chunk("tRNS", "\1\2\3")));
    if (bits < 8) continue;
    all.push_back(png({size, 5, bits, 2}, stored(rows(5, row(3)))));
    all.push_back(png({size, 5, bits, 4}, stored(rows(5, row(2)))));
    all.push_back(png({size, 5, bits, 6}, stored(rows(5, row(4)))));
  }
  const std::string passes("\0\13\0\26\0\41\54", 7);
  all.push_back(png({2, 2, 8, 0, 1}, stored(passes)));
  Image image{40, 30, {}};
  for (std::size_t i = 0; i < 3600; ++i) image.pixels.push_back(static_cast<std::uint8_t>(i / 90 * i));
  all.push_back(hair::encode_png(image));
  return all;
}
