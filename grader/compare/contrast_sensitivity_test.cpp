// STAFF ONLY. Tests the filter on waves of known frequency.
#include "grader/compare/contrast_sensitivity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace grader::inline compare {
namespace {

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
