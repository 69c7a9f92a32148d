// STAFF ONLY. Tests the choice of 256 colours.
#include "grader/compare/palette.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "grader/compare/test_pictures.h"
#include "hair/io/image/read_png.h"

namespace grader::inline compare {
namespace {

using hair::Image;

// Each pixel has another colour.
Image many_colors(int width, int height) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (const int value : {x * 255 / width, y * 255 / height, (x + y) % 256})
        image.pixels.push_back(static_cast<std::uint8_t>(value));
  return image;
}

std::size_t count_colors(const Image& image) {
  std::set<std::array<std::uint8_t, 3>> colors;
  for (std::size_t i = 0; i < image.pixels.size(); i += 3)
    colors.insert({image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]});
  return colors.size();
}

double root_mean_square(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) sum += std::pow(a.pixels[i] - b.pixels[i], 2);
  return std::sqrt(sum / static_cast<double>(a.pixels.size()));
}

Image written_and_read(const Image& image, std::size_t most) {
  return hair::decode_png(encode_palette_png(in_few_colors(image, most)), "a picture");
}

TEST(Palette, OfAPictureWithFewColorsIsThePictureItself) {
  Image image{7, 3, {}};
  for (int i = 0; i < 21; ++i)
    for (const int value : {i * 12, 255 - i, i % 2 * 200})
      image.pixels.push_back(static_cast<std::uint8_t>(value));
  for (const std::size_t most : {21, 22, 256}) {
    const Image read = written_and_read(image, most);
    EXPECT_EQ(read.width, 7);
    EXPECT_EQ(read.height, 3);
    EXPECT_EQ(read.pixels, image.pixels) << most;
  }
}

TEST(Palette, HasNoMoreColorsThanAsked) {
  for (const std::size_t most : {1, 2, 3, 17, 128, 256})
    EXPECT_LE(count_colors(written_and_read(many_colors(64, 48), most)), most);
}

// n cells suffice if a side has the cube root of n, rounded down. Numbers of an interval have a standard
// deviation of half its length at most; a mean is rounded, too.
TEST(Palette, IsAsNearAsItsNumberOfColorsAllows) {
  const Image image = many_colors(120, 100);
  for (const std::size_t most : {8, 64, 256}) {
    const double side = std::ceil(256 / std::floor(std::cbrt(most + 0.5)));
    EXPECT_LE(root_mean_square(written_and_read(image, most), image), side / 2 + 0.5) << most;
  }
}

TEST(Palette, GivesTheSameBytesAgain) {
  const Image image = many_colors(60, 40);
  EXPECT_EQ(encode_palette_png(in_few_colors(image, 64)), encode_palette_png(in_few_colors(image, 64)));
}

TEST(Palette, TakesAThirdOfAPicturesBytesAtMost) {
  const Image image = strands(480, 270, 20);
  EXPECT_LE(3 * encode_palette_png(in_few_colors(image, 128)).size(), hair::encode_png(image).size());
}

TEST(Palette, RefusesNoColorsTooManyAndNoPicture) {
  EXPECT_THROW(in_few_colors(many_colors(2, 2), 0), std::invalid_argument);
  EXPECT_THROW(in_few_colors(many_colors(2, 2), 257), std::invalid_argument);
  EXPECT_THROW(in_few_colors({}, 2), std::invalid_argument);
}

}  // namespace
}  // namespace grader::compare
