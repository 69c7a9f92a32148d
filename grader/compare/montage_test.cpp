// STAFF ONLY. Tests that pictures side by side keep their pixels, and the colours of a heat map.
#include "grader/compare/montage.h"

#include <gtest/gtest.h>

#include <vector>

#include "grader/compare/heat_map.h"
#include "grader/compare/test_pictures.h"

namespace grader::inline compare {
namespace {

using hair::Image;

TEST(SideBySide, KeepsEveryPixelAndPutsALineBetween) {
  const Image a = noise(5, 4, 1), b = noise(3, 4, 2);
  const Image both = side_by_side({a, b});
  ASSERT_EQ(both.width, 5 + 8 + 3);
  ASSERT_EQ(both.pixels.size(), 3u * 16 * 4);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 16; ++x)
      for (int c = 0; c < 3; ++c) {
        const int expected = x < 5 ? a.at(x, y)[c] : x < 13 ? 24 : b.at(x - 13, y)[c];
        EXPECT_EQ(both.at(x, y)[c], expected) << x << ", " << y;
      }
  EXPECT_EQ(side_by_side({a}), a);
}

TEST(Shrunk, EachPixelIsTheMeanOfWhatItCovers) {
  Image image{4, 2, {}};
  for (const int value : {0, 100, 10, 20, 40, 60, 30, 40})
    image.pixels.insert(image.pixels.end(), 3, static_cast<std::uint8_t>(value));
  const Image half = shrunk(image, 2);
  EXPECT_EQ(half.width, 2);
  EXPECT_EQ(half.height, 1);
  EXPECT_EQ(half.pixels, (std::vector<std::uint8_t>{50, 50, 50, 25, 25, 25}));
}

// Three pixels become two: each covers one and a half.
TEST(Shrunk, PixelsAreSharedWhereTheyMust) {
  Image image{3, 1, {}};
  for (const int value : {30, 60, 90})
    image.pixels.insert(image.pixels.end(), 3, static_cast<std::uint8_t>(value));
  EXPECT_EQ(shrunk(image, 2).pixels, (std::vector<std::uint8_t>{40, 40, 40, 80, 80, 80}));
}

TEST(HeatMap, HasTheMapsSizeAndItsEndsColours) {
  Plane map(3, 1);
  map.values = {-1, 0.5F, 2};
  const hair::Image image = heat_map(map);
  EXPECT_EQ(image.width, 3);
  EXPECT_EQ(image.height, 1);
  EXPECT_EQ(image.pixels, (std::vector<std::uint8_t>{0, 0, 4, 181, 54, 122, 252, 253, 191}));
}

}  // namespace
}  // namespace grader::compare
