#include "hair/render/opengl/gl_context.h"

#include <dlfcn.h>

#include <array>
#include <cstdint>

#include "hair/render/opengl/renderer.h"

namespace hair {
namespace {

// GL/osmesa.h
constexpr int kOsFormat = 0x22, kOsRgba = 0x1908, kOsDepthBits = 0x30, kOsProfile = 0x33, kOsCore = 0x34,
              kOsMajor = 0x36, kOsMinor = 0x37;

// EGL/egl.h, EGL/eglext.h
constexpr unsigned kEglSurfaceless = 0x31DD, kEglOpenGl = 0x30A2;
constexpr std::int32_t kEglNone = 0x3038, kEglSurfaceType = 0x3033, kEglRenderableType = 0x3040,
                       kEglOpenGlBit = 0x0008, kEglMajor = 0x3098, kEglMinor = 0x30FB, kEglProfile = 0x30FD,
                       kEglCore = 0x0001;

template <class Type>
Type as(void* symbol) {
  return reinterpret_cast<Type>(symbol);
}

}  // namespace

GlContext::GlContext(const std::string& library) {
  std::string tried;
  const auto open = [&](const std::string& name) {
    const bool egl = name.find("EGL") != std::string::npos;
    library_ = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
    const char* const why_not = library_ == nullptr ? "is not there"
                                : egl               ? "has no OpenGL 3.3 without a window"
                                                    : "has no OpenGL 3.3";
    if (library_ != nullptr && (egl ? open_egl() : open_osmesa())) return true;
    tried += (tried.empty() ? "" : ", ") + name + " (" + why_not + ")";
    close();
    return false;
  };
  const bool opened = library.empty()
                          ? open("libOSMesa.so.8") || open("libOSMesa.so.6") || open("libEGL.so.1")
                          : open(library);
  if (!opened) {
    throw NoOpenGl("no OpenGL 3.3 here: tried " + tried +
                   "; install Debian's and Ubuntu's package libosmesa6, or libegl1 and libegl-mesa0 (there "
                   "are none for macOS)");
  }
  const Current current(*this);
  const auto text = [&](gl::Enum name) {
    const unsigned char* const found = functions_.GetString(name);
    return std::string(found == nullptr ? "?" : reinterpret_cast<const char*>(found));
  };
  about_ = std::string(display_ == nullptr ? "OSMesa: " : "EGL: ") + text(gl::kRenderer) + ", " +
           text(gl::kVersion);
}

GlContext::~GlContext() {
  close();
}

GlContext::Current::Current(const GlContext& context) : context_(context) {
  if (!context_.make_current(true)) throw std::runtime_error("OpenGL's context can't be used in this thread");
}

GlContext::Current::~Current() {
  context_.make_current(false);
}

void* GlContext::symbol(const char* name) const {
  return dlsym(library_, name);
}

bool GlContext::open_osmesa() {
  const auto create = as<void* (*)(const int*, void*)>(symbol("OSMesaCreateContextAttribs"));
  const auto find = as<Function (*)(const char*)>(symbol("OSMesaGetProcAddress"));
  if (create == nullptr || find == nullptr || symbol("OSMesaMakeCurrent") == nullptr ||
      symbol("OSMesaDestroyContext") == nullptr) {
    return false;
  }
  const std::array attributes = {kOsFormat, kOsRgba, kOsDepthBits, 0, kOsProfile, kOsCore,
                                 kOsMajor,  3,       kOsMinor,     3, 0};
  context_ = create(attributes.data(), nullptr);
  return context_ != nullptr && find_functions(find);
}

bool GlContext::open_egl() {
  const auto find = as<Function (*)(const char*)>(symbol("eglGetProcAddress"));
  const auto initialize = as<unsigned (*)(void*, std::int32_t*, std::int32_t*)>(symbol("eglInitialize"));
  const auto bind = as<unsigned (*)(unsigned)>(symbol("eglBindAPI"));
  const auto choose = as<unsigned (*)(void*, const std::int32_t*, void**, std::int32_t, std::int32_t*)>(
      symbol("eglChooseConfig"));
  const auto create = as<void* (*)(void*, void*, void*, const std::int32_t*)>(symbol("eglCreateContext"));
  if (find == nullptr || initialize == nullptr || bind == nullptr || choose == nullptr || create == nullptr ||
      symbol("eglMakeCurrent") == nullptr || symbol("eglDestroyContext") == nullptr) {
    return false;
  }
  const auto display_of = as<void* (*)(unsigned, void*, const std::int32_t*)>(
      reinterpret_cast<void*>(find("eglGetPlatformDisplayEXT")));
  if (display_of == nullptr) return false;
  display_ = display_of(kEglSurfaceless, nullptr, nullptr);
  if (display_ == nullptr || initialize(display_, nullptr, nullptr) == 0 || bind(kEglOpenGl) == 0)
    return false;
  const std::array<std::int32_t, 5> wanted = {kEglSurfaceType, 0, kEglRenderableType, kEglOpenGlBit,
                                              kEglNone};
  void* config = nullptr;
  std::int32_t found = 0;
  if (choose(display_, wanted.data(), &config, 1, &found) == 0 || found < 1) return false;
  const std::array<std::int32_t, 7> attributes = {kEglMajor,   3,        kEglMinor, 3,
                                                  kEglProfile, kEglCore, kEglNone};
  context_ = create(display_, config, nullptr, attributes.data());
  return context_ != nullptr && find_functions(find);
}

bool GlContext::find_functions(Function (*find)(const char*)) {
  bool all = true;
  // The functions are found while the context is current, because libraries promise an answer only then.
  if (!make_current(true)) return false;
#define HAIR_GL_FIND(name, type)                                                              \
  functions_.name = as<decltype(functions_.name)>(reinterpret_cast<void*>(find("gl" #name))); \
  all = all && functions_.name != nullptr;
  using namespace gl;
  HAIR_GL_FUNCTIONS(HAIR_GL_FIND)
#undef HAIR_GL_FIND
  make_current(false);
  return all;
}

bool GlContext::make_current(bool on) const {
  if (display_ != nullptr) {
    const auto make = as<unsigned (*)(void*, void*, void*, void*)>(symbol("eglMakeCurrent"));
    return make(display_, nullptr, nullptr, on ? context_ : nullptr) != 0;
  }
  const auto make = as<unsigned char (*)(void*, void*, unsigned, int, int)>(symbol("OSMesaMakeCurrent"));
  return make(on ? context_ : nullptr, on ? memory_ : nullptr, gl::kUnsignedByte, on ? 16 : 0, on ? 16 : 0) !=
         0;
}

// The library stays loaded: Mesa's threads and thread-local data outlive its contexts.
void GlContext::close() {
  if (context_ != nullptr && display_ != nullptr) {
    as<unsigned (*)(void*, void*)>(symbol("eglDestroyContext"))(display_, context_);
  } else if (context_ != nullptr) {
    as<void (*)(void*)>(symbol("OSMesaDestroyContext"))(context_);
  }
  context_ = nullptr;
  display_ = nullptr;
  library_ = nullptr;
}

}  // namespace hair
