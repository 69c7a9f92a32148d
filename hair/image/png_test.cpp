#include "hair/image/png.h"

#include <gtest/gtest.h>

namespace hair {
namespace {
TEST(Png, RoundTrip) {
  Image image{3, 2, {}};
  for (int i = 0; i < 18; ++i) image.pixels.push_back(static_cast<std::uint8_t>(14 * i));
  EXPECT_EQ(decode_png(encode_png(image), "a"), image);
}
}  // namespace
}  // namespace hair
