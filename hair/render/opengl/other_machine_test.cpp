// Simulates another machine: another library, vectors of another width, another driver. Each draws in a
// process of its own.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "hair/io/files/start_program.h"
#include "hair/io/image/read_png.h"
#include "hair/render/opengl/renderer.h"
#include "hair/render/test_drawing.h"

namespace hair {
namespace {

Image drawn_here() {
  const TestScene scene = test_scene(16.0 / 9);
  return Renderer({.width = 240, .height = 135}).draw(scene.drawing, scene.camera);
}

// Drawn in a fresh process with one more variable in its environment.
Image drawn_there(const std::string& library, const std::string& variable) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("hair-other-machine-" + std::to_string(getpid()) + ".png");
  Program program{.words = {HAIR_DRAW_TEST_SCENE, library, file.string()}};
  if (!variable.empty()) program.environment.push_back(variable);
  const std::optional<int> code = exit_code_of(start_program(program));
  Image image;
  if (code == 0) image = read_png(file);
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
  return image;
}

// True if two pictures show the same geometry, even if two different machines drew them: they have the same
// size, at most 0.05 % of the pixels differ by more than 2 of 255 in a channel, and the root mean square over
// all channels is at most 0.5 of 255. The largest difference is not tested: at the edge of a strand, another
// machine's rounding turns one sample on or off.
bool same_on_another_machine(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height || a.pixels.size() != b.pixels.size()) return false;
  std::size_t off = 0, squares = 0;
  for (std::size_t i = 0; i + 2 < a.pixels.size(); i += 3) {
    bool is_off = false;
    for (std::size_t c = i; c < i + 3; ++c) {
      const int difference = std::abs(int{a.pixels[c]} - int{b.pixels[c]});
      is_off = is_off || difference > 2;
      squares += static_cast<std::size_t>(difference * difference);
    }
    off += is_off;
  }
  const std::size_t pixels = a.pixels.size() / 3;
  return off * 2000 <= pixels && 4 * squares <= 3 * pixels;
}

bool has(const std::string& library) {
  try {
    const Renderer renderer({.width = 16, .height = 16, .library = library});
    return true;
  } catch (const NoOpenGl&) {
    return false;
  }
}

std::string difference(const Image& a, const Image& b) {
  if (a.pixels.size() != b.pixels.size()) return "sizes differ";
  std::size_t off = 0;
  double squares = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const int d = a.pixels[i] - b.pixels[i];
    off += d > 2 || d < -2 ? 1 : 0;
    squares += d * d;
  }
  return std::to_string(off) + " of " + std::to_string(a.pixels.size()) +
         " values are off by more than 2, RMSE " +
         std::to_string(std::sqrt(squares / static_cast<double>(a.pixels.size()))) + " / 255";
}

constexpr int kGreyWidth = 100, kGreyHeight = 80;  // 8000 pixels: 0.05 % are four

// Grey, with `pixels` pixels that differ by `by` in one channel.
Image off(int pixels, int by) {
  Image image{kGreyWidth, kGreyHeight, std::vector<std::uint8_t>(3 * kGreyWidth * kGreyHeight, 100)};
  for (int i = 0; i < pixels; ++i) image.pixels[3 * static_cast<std::size_t>(i) + i % 3] += by;
  return image;
}

// The sum of squares may be a quarter of 24,000 channels: 6000, by 1500 pixels off by 2.
TEST(OtherMachine, FourOf8000PixelsMayBeOffByAnythingAndTheRootMeanSquareIsAtMostHalf) {
  const struct {
    int pixels, by;
    bool same;
  } rows[] = {{0, 0, true},    {4, 30, true},    {5, 30, false}, {1000, 2, true}, {600, 3, false},
              {1500, 2, true}, {1501, 2, false}, {1, 77, true},  {1, 78, false}};
  for (const auto& [pixels, by, same] : rows) {
    EXPECT_EQ(same_on_another_machine(off(0, 0), off(pixels, by)), same) << pixels << " off by " << by;
    EXPECT_EQ(same_on_another_machine(off(pixels, by), off(0, 0)), same) << pixels << " off by " << by;
  }
  EXPECT_TRUE(same_on_another_machine({}, {}));
  EXPECT_FALSE(same_on_another_machine(off(0, 0), {kGreyHeight, kGreyWidth, off(0, 0).pixels}));
  EXPECT_FALSE(same_on_another_machine(off(0, 0), {}));
}

TEST(OtherMachine, AFreshProcessDrawsTheSameBytes) {
  EXPECT_TRUE(drawn_there("", "") == drawn_here());
}

TEST(OtherMachine, EglDrawsTheSamePicture) {
  if (!has("libEGL.so.1")) GTEST_SKIP() << "no EGL here";
  const Image here = drawn_here(), there = drawn_there("libEGL.so.1", "");
  RecordProperty("difference", difference(here, there));
  EXPECT_TRUE(same_on_another_machine(here, there)) << difference(here, there);
}

TEST(OtherMachine, NarrowerVectorsDrawTheSamePicture) {
  const Image here = drawn_here(), there = drawn_there("", "LP_NATIVE_VECTOR_WIDTH=128");
  RecordProperty("difference", difference(here, there));
  EXPECT_TRUE(same_on_another_machine(here, there)) << difference(here, there);
}

TEST(OtherMachine, AnotherDriverDrawsTheSamePicture) {
  const Image here = drawn_here(), there = drawn_there("", "GALLIUM_DRIVER=softpipe");
  RecordProperty("difference", difference(here, there));
  EXPECT_TRUE(same_on_another_machine(here, there)) << difference(here, there);
}

}  // namespace
}  // namespace hair
