// STAFF ONLY. Tests that heat colours are brighter where the error is larger.
#include "grader/compare/heat_map.h"

#include <gtest/gtest.h>

#include <limits>

#include "grader/compare/color.h"

namespace grader::inline compare {
namespace {

double lightness(const HeatColor& color) {
  return lab_from_xyz(xyz_from_linear(
      {linear_from_srgb(color[0]), linear_from_srgb(color[1]), linear_from_srgb(color[2])}))[0];
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
