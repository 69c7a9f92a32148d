#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/temporary_folder.h"
#include "hair/io/files/write_file.h"
#include "hair/io/image/read_png.h"
#include "solver/test_refusal.h"

namespace hair {
namespace {

// --- PNG files made by hand: kinds that encode_png does not write, and files that contradict themselves.
// Source: Portable Network Graphics (PNG) Specification, Second Edition, W3C 2003.

std::string big_endian(std::uint32_t number) {
  return {static_cast<char>(number >> 24), static_cast<char>(number >> 16), static_cast<char>(number >> 8),
          static_cast<char>(number)};
}

// The CRC of a chunk's type and data, bit by bit.
std::uint32_t checksum(std::string_view bytes) {
  std::uint32_t c = 0xffffffffU;
  for (const char byte : bytes) {
    c ^= static_cast<std::uint8_t>(byte);
    for (int bit = 0; bit < 8; ++bit) c = (c & 1) != 0 ? 0xedb88320U ^ c >> 1 : c >> 1;
  }
  return ~c;
}

std::string chunk(const std::string& type, const std::string& data) {
  return big_endian(static_cast<std::uint32_t>(data.size())) + type + data +
         big_endian(checksum(type + data));
}

// zlib's data without compression.
std::string stored(const std::string& raw) {
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

std::string png(const Header& header, const std::string& zlib, const std::string& before_data = "") {
  const std::string fields = big_endian(header.width) + big_endian(header.height) + header.bits +
                             header.kind + '\0' + '\0' + header.interlaced;
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", fields) + before_data + chunk("IDAT", zlib) + chunk("IEND", "");
}

// ---

Image speckled(int width, int height) {
  Image image{width, height, {}};
  for (int i = 0; i < 3 * width * height; ++i) {
    image.pixels.push_back(static_cast<std::uint8_t>(static_cast<unsigned>(i) * 2654435761U >> 24));
  }
  return image;
}

std::string bytes(const std::vector<int>& numbers) {
  return {numbers.begin(), numbers.end()};
}

using Pixels = std::vector<std::uint8_t>;

// The message that decode_png throws, or "".
std::string refusal(const std::string& file) {
  return tests::refusal<BadInput>([&] { decode_png(file, "a.png"); });
}

TEST(Png, WhatIsWrittenIsReadAgain) {
  for (const auto& [width, height] : std::vector<std::pair<int, int>>{{1, 1}, {7, 3}, {320, 180}}) {
    const Image image = speckled(width, height);
    const std::string file = encode_png(image);
    EXPECT_TRUE(decode_png(file, "a.png") == image) << width << " x " << height;
    EXPECT_EQ(encode_png(image), file) << "the same bytes again";
  }
}

TEST(Png, KindsThatOthersWrite) {
  const std::string grey = bytes({0, 10, 200});
  EXPECT_EQ(decode_png(png({2, 1, 8, 0}, stored(grey)), "").pixels, (Pixels{10, 10, 10, 200, 200, 200}));
  const std::string one_bit = bytes({0, 0x40});
  EXPECT_EQ(decode_png(png({2, 1, 1, 0}, stored(one_bit)), "").pixels, (Pixels{0, 0, 0, 255, 255, 255}));
  const std::string sixteen = bytes({0, 10, 99, 20, 99, 30, 99});
  EXPECT_EQ(decode_png(png({1, 1, 16, 2}, stored(sixteen)), "").pixels, (Pixels{10, 20, 30}));
  const std::string palette = chunk("PLTE", bytes({1, 2, 3, 40, 50, 60}));
  EXPECT_EQ(decode_png(png({2, 1, 8, 3}, stored(bytes({0, 1, 0})), palette), "").pixels,
            (Pixels{40, 50, 60, 1, 2, 3}));
}

// Leaves numbers on the stack, for a decoder that reads uninitialised memory.
[[gnu::noinline]] void scribble() {
  volatile char left[100'000];
  for (volatile char& byte : left) byte = 0x66;
}

TEST(Png, AColourThatThePaletteLacksIsBlack) {
  scribble();
  const std::string palette = chunk("PLTE", bytes({1, 2, 3})), indices = stored(bytes({0, 0, 1, 255}));
  EXPECT_EQ(decode_png(png({3, 1, 8, 3}, indices, palette), "").pixels, (Pixels{1, 2, 3, 0, 0, 0, 0, 0, 0}));
  EXPECT_NE(refusal(png({3, 1, 8, 3}, indices, chunk("PLTE", ""))), "");
  EXPECT_NE(refusal(png({3, 1, 8, 3}, indices, chunk("PLTE", bytes({1, 2, 3, 4})))), "");
  EXPECT_NE(refusal(png({3, 1, 8, 3}, indices, chunk("PLTE", std::string(771, '\1')))), "");
}

// An iPhone's PNG has data without a header, which make more bytes than the header's size allows.
TEST(Png, ACriticalChunkThatNoPngHasIsRefused) {
  const std::string raw = stored(bytes({0, 9}));
  EXPECT_EQ(
      refusal(png({1, 1, 8, 0}, raw, chunk("CgBI", bytes({0, 0, 0, 0})))),
      "a.png: can't be decoded (CgBI: unhandled critical chunk); give a whole PNG file, or make it anew");
  EXPECT_EQ(refusal(png({1, 1, 8, 0}, raw, chunk("tEXt", "a"))), "");
}

TEST(Png, WhatIsTransparentIsPutOnBlack) {
  const std::string half = bytes({0, 200, 100, 50, 128, 9, 9, 9, 0});
  // 200 * 128 / 255 = 100.4 and so on, rounded.
  EXPECT_EQ(decode_png(png({2, 1, 8, 6}, stored(half)), "").pixels, (Pixels{100, 50, 25, 0, 0, 0}));
  EXPECT_EQ(decode_png(png({1, 1, 8, 4}, stored(bytes({0, 200, 128}))), "").pixels, (Pixels{100, 100, 100}));
}

// A 2 x 2 picture has pixels in the first, the sixth and the last of the seven passes.
TEST(Png, InterlacedPicturesAreReadToo) {
  const std::string passes = bytes({0, 11, 0, 22, 0, 33, 44});
  EXPECT_EQ(decode_png(png({2, 2, 8, 0, 1}, stored(passes)), "").pixels,
            (Pixels{11, 11, 11, 22, 22, 22, 33, 33, 33, 44, 44, 44}));
}

TEST(Png, CutOffAnywhereIsRefused) {
  const std::string file = encode_png(speckled(9, 5));
  for (std::size_t length = 0; length < file.size(); ++length) {
    EXPECT_NE(refusal(file.substr(0, length)), "") << length << " of " << file.size() << " bytes";
  }
  EXPECT_EQ(refusal(file), "");
}

// A checksum detects each changed byte, also in the checksum itself.
TEST(Png, DamagedAnywhereIsRefused) {
  const std::string file = encode_png(speckled(9, 5));
  for (std::size_t i = 0; i < file.size(); ++i) {
    std::string damaged = file;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
    EXPECT_NE(refusal(damaged), "") << "byte " << i;
  }
}

TEST(Png, AHeaderThatLiesIsRefusedBeforeItsMemoryIsTaken) {
  const std::string some = stored(bytes({0, 1, 2, 3}));
  for (const Header& header :
       {Header{0, 1, 8, 2}, Header{1, 0, 8, 2}, Header{16385, 1, 8, 2}, Header{1, 0xffffffffU, 8, 2},
        Header{16384, 16384, 8, 2}, Header{1, 1, 8, 5}, Header{1, 1, 8, 7}, Header{1, 1, 77, 2},
        Header{1, 1, 0, 2}, Header{1, 1, 5, 2}}) {
    const std::string why = refusal(png(header, some));
    EXPECT_EQ(why.find("a.png: "), 0U) << header.width << " x " << header.height << ": " << why;
    EXPECT_EQ(why.find('\n'), std::string::npos);
  }
  EXPECT_NE(refusal(png({16384, 16384, 8, 2}, some)).find("64 million"), std::string::npos);
  EXPECT_NE(refusal(png({4000, 4000, 8, 2}, some)), "") << "too few data for its size";
}

// Data that inflate to more than the header's size are refused, whatever their size.
TEST(Png, DataThatAreTooManyAreRefused) {
  const std::string many = stored(std::string(5000, '\0'));
  EXPECT_NE(refusal(png({2, 1, 8, 0}, many)).find("Too much image data"), std::string::npos);
}

TEST(Png, WhatIsNoPngIsRefusedWithItsName) {
  for (const std::string& file :
       {std::string(), std::string("GIF89a"), std::string("\x89PNG\r\n\x1a\n"),
        "\x89PNG\r\n\x1a\n" + chunk("IEND", ""), "\x89PNG\r\n\x1a\n" + chunk("IDAT", ""),
        png({1, 1, 8, 3}, stored(bytes({0, 0})))}) {
    EXPECT_EQ(refusal(file).find("a.png: "), 0U);
  }
  const std::string file = encode_png(speckled(2, 2));
  EXPECT_NE(refusal(file.substr(0, 33) + file.substr(8)), "") << "two headers";
  EXPECT_NE(refusal(file.substr(0, 33) + chunk("IEND", "")), "") << "no data";
}

TEST(Png, FilesThatCantBeReadOrWrittenAreNamed) {
  const TemporaryFolder folder("hair-png-test");
  const std::filesystem::path file = folder.path() / "a.png";
  write_file(file, encode_png(speckled(4, 4)));
  EXPECT_TRUE(read_png(file) == speckled(4, 4));
  for (const std::filesystem::path& none : {folder.path() / "none.png", folder.path()})
    EXPECT_TRUE(tests::refusal<BadInput>([&] { read_png(none); }).starts_with(none.string()));
}

TEST(Png, APictureWhoseSizeIsWrongIsNotWritten) {
  EXPECT_THROW(encode_png({2, 2, Pixels(11)}), std::invalid_argument);
  EXPECT_THROW(encode_png({}), std::invalid_argument);
  EXPECT_THROW(encode_png({-1, -1, Pixels(3)}), std::invalid_argument);
}

}  // namespace
}  // namespace hair
