// STAFF ONLY. Tests filters of planes against direct sums.
#include "grader/compare/plane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

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

}  // namespace
}  // namespace grader::compare
