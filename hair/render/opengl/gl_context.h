// OpenGL 3.3 core without a window. Loads a library at run time: OSMesa, which draws into memory, or EGL on
// Mesa's surfaceless platform. Sources: Mesa's GL/osmesa.h; Khronos, EGL 1.5 and
// EGL_MESA_platform_surfaceless.
#pragma once

#include <string>

#include "hair/render/opengl/gl.h"

namespace hair {

class GlContext {
 public:
  // `library`: the library to load, with EGL if its name says so; empty: any available one. Throws NoOpenGl.
  explicit GlContext(const std::string& library);
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  // Makes the context current in this thread as long as the object lives. Contexts of different libraries can
  // alternate.
  class Current {
   public:
    explicit Current(const GlContext& context);
    ~Current();
    Current(const Current&) = delete;
    Current& operator=(const Current&) = delete;

   private:
    const GlContext& context_;
  };

  const gl::Functions& functions() const { return functions_; }
  std::string about() const { return about_; }

 private:
  using Function = void (*)();

  bool open_osmesa();
  bool open_egl();
  bool find_functions(Function (*find)(const char*));
  void* symbol(const char* name) const;
  bool make_current(bool on) const;
  void close();

  void* library_ = nullptr;
  void* display_ = nullptr;  // EGL's; none with OSMesa
  void* context_ = nullptr;
  mutable unsigned char memory_[4 * 16 * 16] = {};  // OSMesa requires its own image
  std::string about_;
  gl::Functions functions_;
};

}  // namespace hair
