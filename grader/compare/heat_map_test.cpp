// STAFF ONLY. Tests the colours of a heat map.
#include "grader/compare/heat_map.h"

#include <gtest/gtest.h>

#include <vector>

namespace grader::inline compare {
namespace {

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
