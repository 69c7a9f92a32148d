// STAFF ONLY. Tests FLIP's error maps on pictures with known differences, and its filter on waves.
#include "grader/compare/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <numeric>

#include "grader/compare/test_pictures.h"
#include "hair/io/image/read_png.h"

namespace grader::inline compare {
namespace {

using hair::Image;

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

// FLIP sees even the smallest shift of strands a pixel wide; compare_test.cpp has the measure that does not.
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
