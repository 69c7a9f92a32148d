// Draws pictures without a window: OpenGL 3.3 core by OSMesa or EGL, whichever this machine has. Both are
// loaded when a renderer is made; no program links them. The same drawing gives the same bytes on one
// machine, and nearly the same picture on another (other_machine_test.cpp).
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "hair/io/image/image.h"
#include "hair/render/camera.h"
#include "hair/render/drawing.h"

namespace hair {

// The error that this machine has no OpenGL: one line with the tried libraries, and the package to install.
class NoOpenGl : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct RenderSettings {
  int width = 1280, height = 720;  // pixels, 16 to 4096
  bool shadows = true;             // false: the pipeline has no shadow passes
  std::string library = {};        // the OpenGL library, such as "libEGL.so.1"; empty: OSMesa, else EGL
};

class Renderer {
 public:
  // Throws NoOpenGl, or std::invalid_argument for settings that are out of bounds.
  explicit Renderer(const RenderSettings& settings);
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  // Throws std::invalid_argument for numbers that are not finite. Reuses its buffers from picture to picture.
  Image draw(const Drawing& drawing, const Camera& camera);

  std::string about() const;  // "OSMesa: llvmpipe (LLVM 15.0.6, 256 bits), 3.3 (Core Profile) Mesa 22.3.6"

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hair
