#include "hair/io/image/same_picture.h"

#include <gtest/gtest.h>

namespace hair {
namespace {

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
