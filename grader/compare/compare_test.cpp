// STAFF ONLY. Tests the distances of pictures: identical, shifted, brighter and with missing hair.
#include "grader/compare/compare.h"

#include <gtest/gtest.h>

#include <cmath>

#include "grader/compare/test_pictures.h"

namespace grader::inline compare {
namespace {

using hair::Image;

// Bounds the rounding of a filter's sums of 25 + 25 floats.
constexpr double kFilterRounding = 50 * 1.2e-7;

TEST(ComparePictures, IdenticalOnesAreAtDistanceZero) {
  const PictureDistance none = compare_pictures(strands(64, 48, 5), strands(64, 48, 5));
  EXPECT_TRUE(none.identical);
  EXPECT_EQ(none.blurred_rmse, 0);
  EXPECT_EQ(none.flip_mean, 0);
  EXPECT_EQ(none.flip_max, 0);
}

TEST(ComparePictures, BlackIsOneFromWhite) {
  const PictureDistance most = compare_pictures(even({0, 0, 0}), even({255, 255, 255}));
  EXPECT_FALSE(most.identical);
  EXPECT_NEAR(most.blurred_rmse, 1, kFilterRounding);
  EXPECT_NEAR(compare_pictures(even({0, 0, 0}), even({0, 255, 0})).blurred_rmse, std::sqrt(1.0 / 3),
              kFilterRounding);
}

// The squares of a Gaussian's weights sum to about 1 / (4 pi sigma^2); cut off at 3 sigma and sampled, they
// are right within a hundredth.
TEST(ComparePictures, OfADotIsTheNormOfTheGaussian) {
  const int size = 64;
  Image dot = even({0, 0, 0}, size, size);
  std::fill_n(dot.pixels.begin() + 3 * (32 * size + 32), 3, 255);
  const double expected = std::sqrt(1 / (4 * M_PI * kBlur * kBlur)) / size;
  EXPECT_NEAR(compare_pictures(even({0, 0, 0}, size, size), dot).blurred_rmse, expected, 0.01 * expected);
}

TEST(ComparePictures, AShiftByAPixelIsLessThanHalfOfTheHairGone) {
  const Image whole = strands(160, 120, 20), moved = strands(160, 120, 20, 1), half = strands(160, 120, 10);
  EXPECT_LT(compare_pictures(whole, moved).blurred_rmse, 0.5 * compare_pictures(whole, half).blurred_rmse);
}

// One strand of twenty is missing.
TEST(ComparePictures, AMissingStrandIsSeen) {
  const PictureDistance one = compare_pictures(strands(160, 120, 20), strands(160, 120, 19));
  EXPECT_GT(one.blurred_rmse, 1e-3);
  EXPECT_GT(one.flip_mean, 1e-3);
}

}  // namespace
}  // namespace grader::compare
