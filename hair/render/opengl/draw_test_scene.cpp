// Draws the test scene in a separate process, whose environment a test sets.
// Usage: draw_test_scene LIBRARY FILE.png    LIBRARY: with OpenGL; empty: any
#include <exception>
#include <iostream>

#include "hair/io/files/write_file.h"
#include "hair/io/image/png.h"
#include "hair/render/opengl/renderer.h"
#include "hair/render/test_drawing.h"

int main(int count, char** arguments) try {
  if (count != 3) {
    std::cerr << "usage: draw_test_scene LIBRARY FILE.png\n";
    return 2;
  }
  const hair::RenderSettings settings{.width = 240, .height = 135, .library = arguments[1]};
  const hair::TestScene scene = hair::test_scene(16.0 / 9);
  hair::Renderer renderer(settings);
  hair::write_file(arguments[2], hair::encode_png(renderer.draw(scene.drawing, scene.camera)));
  std::cout << renderer.about() << '\n';
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
