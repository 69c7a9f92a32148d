// STAFF ONLY. Tests filters of planes against direct sums, the distances of pictures (identical, shifted,
// brighter, with missing hair), and pictures side by side, made smaller and of errors.
#include "grader/compare/compare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <numeric>
#include <vector>

#include "grader/compare/flip.h"
#include "grader/compare/montage.h"
#include "grader/compare/test_pictures.h"
#include "hair/io/image/read_png.h"

namespace grader::inline compare {
namespace {

// Each value has a float's full rounding: eps / 2 relative for each of the kernel's products and sums.
constexpr float kKernelRounding = 60 * 1.2e-7F;

Plane random_plane(int width, int height) {
  Plane plane(width, height);
  unsigned state = 1;
  for (float& value : plane.values)
    value = static_cast<float>((state = state * 1664525U + 1013904223U) >> 16) / 65536;
  return plane;
}

// Follows the definition: a sum over a square, with the border's values beyond it.
float at(const Plane& in, const Kernel& rows, const Kernel& columns, int x, int y) {
  double sum = 0;
  const int side = static_cast<int>(rows.size() / 2), up = static_cast<int>(columns.size() / 2);
  for (int i = 0; i <= 2 * side; ++i)
    for (int j = 0; j <= 2 * up; ++j)
      sum += double{rows[static_cast<std::size_t>(i)]} * columns[static_cast<std::size_t>(j)] *
             in.row(std::clamp(y + j - up, 0, in.height - 1))[std::clamp(x + i - side, 0, in.width - 1)];
  return static_cast<float>(sum);
}

TEST(Gaussian, SumsToOneAndIsSymmetric) {
  for (const double sigma : {0.5, 1.0, 4.0}) {
    const Kernel kernel = gaussian(sigma, 12);
    ASSERT_EQ(kernel.size(), 25u);
    EXPECT_NEAR(std::accumulate(kernel.begin(), kernel.end(), 0.0), 1, 25 * 6e-8);
    EXPECT_TRUE(std::equal(kernel.begin(), kernel.end(), kernel.rbegin()));
    EXPECT_NEAR(kernel[13] / kernel[12], std::exp(-0.5 / (sigma * sigma)), 2e-7);
  }
}

TEST(Filtered, IsTheSumOfItsDefinitionUpToTheBorders) {
  const Kernel lopsided{0.5F, -1, 2, 0.25F, -0.125F}, wide = gaussian(2, 9);
  for (const auto& [width, height] : {std::pair{7, 5}, {1, 1}, {1, 30}, {30, 1}, {25, 24}}) {
    const Plane in = random_plane(width, height);
    const Plane out = filtered(in, lopsided, wide);
    ASSERT_EQ(out.width, width);
    ASSERT_EQ(out.height, height);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        EXPECT_NEAR(out.row(y)[x], at(in, lopsided, wide, x, y), 4 * kKernelRounding)
            << x << ", " << y << " of " << width << " x " << height;
  }
}

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
  const Image image = heat_map(map);
  EXPECT_EQ(image.width, 3);
  EXPECT_EQ(image.height, 1);
  EXPECT_EQ(image.pixels, (std::vector<std::uint8_t>{0, 0, 4, 181, 54, 122, 252, 253, 191}));
}

double mean(const ErrorMap& map) {
  return std::accumulate(map.values.begin(), map.values.end(), 0.0) / static_cast<double>(map.values.size());
}

double largest(const ErrorMap& map) {
  return *std::max_element(map.values.begin(), map.values.end());
}

// These are a photograph and its copy by a video codec, published with 67.02 pixels per degree: the mean
// agrees within 1e-4.
TEST(Flip, OfThePublishedPairIsThePublishedOne) {
  const char* folder = std::getenv("HAIR_IMAGES");
  if (folder == nullptr) GTEST_SKIP() << "HAIR_IMAGES is not set to the folder with tree-ref.png";
  const Image reference = hair::read_png(std::filesystem::path(folder) / "tree-ref.png");
  const Image test = hair::read_png(std::filesystem::path(folder) / "tree-test.png");
  const ErrorMap map = flip(reference, test, 67.02);
  EXPECT_NEAR(mean(map), 0.133285, 1e-4);
  EXPECT_NEAR(largest(map), 0.983044, 1e-4);
}

TEST(Flip, IsSymmetric) {
  const Image a = strands(64, 48, 5), b = strands(64, 48, 7);
  const ErrorMap forth = flip(a, b), back = flip(b, a);
  EXPECT_EQ(forth.values, back.values);
}

// Even pictures have no features, and filters do not change them, so that colours alone decide. CIELAB of
// sRGB's primaries is from B. Lindbloom, www.brucelindbloom.com, with four decimals: (87.7347, -86.1827,
// 83.1793) is green, (32.2970, 79.1875, -107.8602) is blue.
TEST(Flip, OfEvenPicturesFollowsFromTheirColours) {
  const auto hunt_distance = [](const Color& a, const Color& b) {
    const auto hunt = [](const Color& lab, std::size_t i) { return 0.01 * lab[0] * lab[i]; };
    return std::abs(a[0] - b[0]) + std::hypot(hunt(a, 1) - hunt(b, 1), hunt(a, 2) - hunt(b, 2));
  };
  const double most =
      std::pow(hunt_distance({87.7347, -86.1827, 83.1793}, {32.2970, 79.1875, -107.8602}), 0.7);
  const auto expect = [](const Image& a, const Image& b, double value) {
    for (const float found : flip(a, b).values) ASSERT_NEAR(found, value, 2e-5);
  };
  // Black and white have L* 0 and 100, beyond the knee at 0.4.
  const double contrast = std::pow(100, 0.7) / most;
  ASSERT_GT(contrast, 0.4);
  expect(even({0, 0, 0}), even({255, 255, 255}), 0.95 + 0.05 * (contrast - 0.4) / 0.6);
  // This difference is the largest of all.
  expect(even({0, 255, 0}), even({0, 0, 255}), 1);
  // These are two greys: sRGB 119 has L* 50.0344, 118 has 49.6365.
  const double step = std::pow(50.0344 - 49.6365, 0.7) / most;
  expect(even({119, 119, 119}), even({118, 118, 118}), 0.95 * step / 0.4);
}

// FLIP sees even the smallest shift of strands a pixel wide; ComparePictures has the measure that does not.
TEST(Flip, AShiftIsTheMoreTheLargerItIs) {
  double before = 0;
  for (int shift = 1; shift <= 3; ++shift) {
    const double now = mean(flip(strands(160, 120, 20), strands(160, 120, 20, shift)));
    EXPECT_GT(now, before) << shift;
    before = now;
  }
}

// A difference in a corner reaches as far as the widest filter: 10 px and 9 px at this distance.
TEST(Flip, ADifferenceStaysWhereItIsAndBordersAddNothing) {
  const Image before = strands(64, 48, 5);
  Image after = before;
  after.pixels[0] ^= 255;
  const ErrorMap map = flip(before, after);
  EXPECT_GT(map.values[0], 0.01);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x)
      if (x > 10 || y > 10) {
        EXPECT_EQ(map.row(y)[x], 0) << x << ", " << y;
      }
}

TEST(Flip, NeedsTwoOfTheSameSize) {
  EXPECT_THROW(flip(noise(3, 2, 1), noise(2, 3, 1)), std::invalid_argument);
  EXPECT_THROW(flip(noise(3, 2, 1), {}), std::invalid_argument);
}

constexpr double kPixels = 67;  // per degree

// Returns how much of a wave of `frequency` cycles per degree is left in the middle of its crest.
double seen_of_wave(Opponent opponent, double frequency) {
  Plane wave(121, 41);
  for (int y = 0; y < wave.height; ++y)
    for (int x = 0; x < wave.width; ++x)
      wave.row(y)[x] = static_cast<float>(std::cos(2 * std::numbers::pi * frequency * (x - 60) / kPixels));
  return seen(wave, opponent, kPixels).row(20)[60];
}

// A Gaussian that is cut off at three standard deviations lacks 0.3 % of its weight; so do its parts.
constexpr double kCutOff = 0.003;

TEST(ContrastSensitivity, OfAWaveIsAGaussianOfItsFrequency) {
  for (const double frequency : {0.0, 3.0, 6.0, 12.0, 18.0, 24.0}) {
    const double square = frequency * frequency;
    EXPECT_NEAR(seen_of_wave(Opponent::achromatic, frequency), std::exp(-0.0047 * square), kCutOff);
    EXPECT_NEAR(seen_of_wave(Opponent::red_green, frequency), std::exp(-0.0053 * square), kCutOff);
  }
}

// Two Gaussians have a weight of a sqrt(b) each.
TEST(ContrastSensitivity, OfBlueAndYellowIsASumOfTwo) {
  const double first = 34.1 * std::sqrt(0.04), second = 13.5 * std::sqrt(0.025);
  for (const double frequency : {0.0, 1.0, 3.0, 6.0, 9.0, 12.0}) {
    const double square = frequency * frequency;
    const double expected =
        (first * std::exp(-0.04 * square) + second * std::exp(-0.025 * square)) / (first + second);
    EXPECT_NEAR(seen_of_wave(Opponent::blue_yellow, frequency), expected, kCutOff) << frequency;
  }
}

}  // namespace
}  // namespace grader::compare
