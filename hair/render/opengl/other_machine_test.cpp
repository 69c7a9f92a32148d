// Simulates another machine: another library, vectors of another width, another driver. Each draws in a
// process of its own.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "hair/io/files/start_program.h"
#include "hair/io/image/read_png.h"
#include "hair/io/image/same_picture.h"
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
