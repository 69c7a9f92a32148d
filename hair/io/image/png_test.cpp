#include <gtest/gtest.h>

#include <unistd.h>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/write_file.h"
#include "hair/io/image/made_png.h"
#include "hair/io/image/read_png.h"
#include "hair/io/image/same_picture.h"
#include "solver/test_refusal.h"

namespace hair {
namespace {

using made::chunk, made::Header, made::png, made::stored;

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
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("hair-png-test-" + std::to_string(getpid()));
  const auto fails = [](const std::filesystem::path& file) {
    try {
      read_png(file);
      return false;
    } catch (const BadInput& error) {
      return std::string(error.what()).find(file.string()) == 0;
    }
  };
  write_png(folder / "a.png", speckled(4, 4));
  EXPECT_TRUE(read_png(folder / "a.png") == speckled(4, 4));
  EXPECT_TRUE(fails(folder / "none.png"));
  EXPECT_TRUE(fails(folder));
  EXPECT_THROW(write_png(folder / "a.png" / "b.png", speckled(4, 4)), BadInput);
  std::filesystem::remove_all(folder);
}

TEST(Png, APictureWhoseSizeIsWrongIsNotWritten) {
  EXPECT_THROW(encode_png({2, 2, Pixels(11)}), std::invalid_argument);
  EXPECT_THROW(encode_png({}), std::invalid_argument);
  EXPECT_THROW(encode_png({-1, -1, Pixels(3)}), std::invalid_argument);
}

constexpr int kWidth = 100, kHeight = 80;  // 8000 pixels: 0.05 % are four

Image grey() {
  return {kWidth, kHeight, std::vector<std::uint8_t>(3 * kWidth * kHeight, 100)};
}

// Grey, with `pixels` pixels that differ by `by` in one channel.
Image off(int pixels, int by) {
  Image image = grey();
  for (int i = 0; i < pixels; ++i) image.pixels[3 * static_cast<std::size_t>(i) + i % 3] += by;
  return image;
}

TEST(SamePicture, EqualPicturesAre) {
  EXPECT_TRUE(same_on_another_machine(grey(), grey()));
  EXPECT_TRUE(same_on_another_machine({}, {}));
}

TEST(SamePicture, FourOf8000PixelsMayBeOffByAnything) {
  EXPECT_TRUE(same_on_another_machine(grey(), off(4, 30)));
  EXPECT_FALSE(same_on_another_machine(grey(), off(5, 30)));
  EXPECT_FALSE(same_on_another_machine(off(5, 30), grey()));
}

TEST(SamePicture, OffByTwoIsNotOff) {
  EXPECT_TRUE(same_on_another_machine(grey(), off(1000, 2)));
  EXPECT_TRUE(same_on_another_machine(off(1000, 2), grey()));
  EXPECT_FALSE(same_on_another_machine(grey(), off(600, 3)));  // squares of 5400, see below
}

// The sum of squares may be a quarter of 24,000 channels: 6000, by 1500 pixels off by 2.
TEST(SamePicture, TheRootMeanSquareIsAtMostHalf) {
  EXPECT_TRUE(same_on_another_machine(grey(), off(1500, 2)));
  EXPECT_FALSE(same_on_another_machine(grey(), off(1501, 2)));
  EXPECT_TRUE(same_on_another_machine(grey(), off(1, 77)));   // 5929
  EXPECT_FALSE(same_on_another_machine(grey(), off(1, 78)));  // 6084
}

TEST(SamePicture, OtherSizesAreNot) {
  EXPECT_FALSE(same_on_another_machine(grey(), {kHeight, kWidth, grey().pixels}));
  EXPECT_FALSE(same_on_another_machine(grey(), {}));
}

}  // namespace
}  // namespace hair
