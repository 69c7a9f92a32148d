#include "hair/render/opengl/gl_objects.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace hair::gl {

namespace {

// Throws with the compiler's words, unless the shader or the program has this status.
void check(const char* action, Name name, Enum status, Pointer<void(Name, Enum, int*)> get,
           Pointer<void(Name, int, int*, char*)> get_words) {
  int done = 0, length = 0;
  get(name, status, &done);
  if (done != 0) return;
  std::string words(2000, '\0');
  get_words(name, static_cast<int>(words.size()), &length, words.data());
  throw std::runtime_error("OpenGL can't " + std::string(action) +
                           " a shader: " + words.substr(0, static_cast<std::size_t>(length)));
}

}  // namespace

Program::Program(const Functions& functions, Pass pass, const std::string& header)
    : gl_(functions), name_(gl_.CreateProgram()) {
  const ShaderPair& shaders = shaders_of(pass);
  gl_.AttachShader(name_, compile(kVertexShader, header + shaders.vertex));
  gl_.AttachShader(name_, compile(kFragmentShader, header + shaders.fragment));
  gl_.LinkProgram(name_);
  check("link", name_, kLinkStatus, gl_.GetProgramiv, gl_.GetProgramInfoLog);
}

void Program::set(const char* name, float value) const {
  gl_.Uniform1f(uniform(name), value);
}
void Program::set(const char* name, float x, float y) const {
  gl_.Uniform2f(uniform(name), x, y);
}
void Program::set(const char* name, const Eigen::Vector3f& value) const {
  gl_.Uniform3f(uniform(name), value[0], value[1], value[2]);
}
void Program::set(const char* name, const Eigen::Vector4f& value) const {
  gl_.Uniform4f(uniform(name), value[0], value[1], value[2], value[3]);
}
void Program::set(const char* name, const Eigen::Matrix4f& value) const {
  gl_.UniformMatrix4fv(uniform(name), 1, 0, value.data());
}
void Program::set(const char* name, int unit, Name texture) const {
  gl_.ActiveTexture(kTexture0 + static_cast<unsigned>(unit));
  gl_.BindTexture(kTexture2D, texture);
  gl_.Uniform1i(uniform(name), unit);
}

Name Program::compile(Enum kind, const std::string& text) const {
  const Name shader = gl_.CreateShader(kind);
  const std::string whole = "#version 330 core\n" + text;
  const char* const source = whole.c_str();
  gl_.ShaderSource(shader, 1, &source, nullptr);
  gl_.CompileShader(shader);
  check("compile", shader, kCompileStatus, gl_.GetShaderiv, gl_.GetShaderInfoLog);
  return shader;
}

namespace {

void take_nearest(const Functions& gl) {
  for (const Enum filter : {kMinFilter, kMagFilter})
    gl.TexParameteri(kTexture2D, filter, static_cast<int>(kNearest));
  for (const Enum wrap : {kWrapS, kWrapT}) gl.TexParameteri(kTexture2D, wrap, static_cast<int>(kClampToEdge));
}

Name make_texture(const Functions& gl, int width, int height, Enum format) {
  Name texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(kTexture2D, texture);
  const bool depth = format == kDepthComponent24;
  gl.TexImage2D(kTexture2D, 0, static_cast<int>(format), width, height, 0, depth ? kDepthComponent : kRgba,
                kFloat, nullptr);
  take_nearest(gl);
  return texture;
}

}  // namespace

Target make_target(const Functions& gl, int width, int height, Enum colour_format, bool with_depth,
                   Name depth) {
  Target target;
  target.width = width;
  target.height = height;
  gl.GenFramebuffers(1, &target.framebuffer);
  gl.BindFramebuffer(kFramebuffer, target.framebuffer);
  if (colour_format != 0) {
    target.colour = make_texture(gl, width, height, colour_format);
    gl.FramebufferTexture2D(kFramebuffer, kColourAttachment0, kTexture2D, target.colour, 0);
  } else {
    gl.DrawBuffer(kNone);
    gl.ReadBuffer(kNone);
  }
  if (with_depth) {
    target.depth = depth != 0 ? depth : make_texture(gl, width, height, kDepthComponent24);
    gl.FramebufferTexture2D(kFramebuffer, kDepthAttachment, kTexture2D, target.depth, 0);
  }
  if (gl.CheckFramebufferStatus(kFramebuffer) != kFramebufferComplete) {
    throw std::runtime_error("OpenGL can't draw into a picture of " + std::to_string(width) + " x " +
                             std::to_string(height) + " samples");
  }
  return target;
}

void draw_into(const Functions& gl, const Target& target) {
  gl.BindFramebuffer(kFramebuffer, target.framebuffer);
  gl.Viewport(0, 0, target.width, target.height);
}

std::vector<float> depths_of(const Functions& gl, const Target& target) {
  std::vector<float> depths(static_cast<std::size_t>(target.width) * static_cast<std::size_t>(target.height));
  draw_into(gl, target);
  gl.ReadPixels(0, 0, target.width, target.height, kDepthComponent, kFloat, depths.data());
  return depths;
}

// OpenGL's lowest row comes first.
Image image_of(const Functions& gl, const Target& target) {
  const auto width = static_cast<std::size_t>(target.width), height = static_cast<std::size_t>(target.height);
  std::vector<std::uint8_t> rgba(4 * width * height);
  draw_into(gl, target);
  gl.ReadPixels(0, 0, target.width, target.height, kRgba, kUnsignedByte, rgba.data());
  Image image{target.width, target.height, std::vector<std::uint8_t>(3 * width * height)};
  for (std::size_t y = 0; y < height; ++y) {
    const std::uint8_t* from = rgba.data() + 4 * width * (height - 1 - y);
    std::uint8_t* to = image.pixels.data() + 3 * width * y;
    for (std::size_t x = 0; x < width; ++x) std::copy_n(from + 4 * x, 3, to + 3 * x);
  }
  return image;
}

FloatTexture::FloatTexture(const Functions& functions) : gl_(functions) {
  gl_.GenTextures(1, &name_);
  gl_.BindTexture(kTexture2D, name_);
  take_nearest(gl_);
}

void FloatTexture::send(int width, int height, int channels, const float* values) {
  gl_.BindTexture(kTexture2D, name_);
  gl_.TexImage2D(kTexture2D, 0, static_cast<int>(channels == 1 ? kR32F : kRgba32F), width, height, 0,
                 channels == 1 ? kRed : kRgba, kFloat, values);
}

Triangles::Triangles(const Functions& functions, const std::vector<int>& attributes) : gl_(functions) {
  gl_.GenVertexArrays(1, &array_);
  gl_.GenBuffers(2, buffers_);
  gl_.BindVertexArray(array_);
  gl_.BindBuffer(kArrayBuffer, buffers_[0]);
  gl_.BindBuffer(kElementArrayBuffer, buffers_[1]);
  int floats = 0;
  for (const int size : attributes) floats += size;
  std::size_t offset = 0;
  for (unsigned i = 0; i < attributes.size(); ++i) {
    gl_.EnableVertexAttribArray(i);
    gl_.VertexAttribPointer(i, attributes[i], kFloat, 0, floats * static_cast<int>(sizeof(float)), offset);
    offset += static_cast<std::size_t>(attributes[i]) * sizeof(float);
  }
}

void Triangles::send(const void* vertices, std::size_t bytes, std::vector<std::uint32_t> indices) {
  gl_.BindVertexArray(array_);
  gl_.BindBuffer(kArrayBuffer, buffers_[0]);
  gl_.BufferData(kArrayBuffer, static_cast<std::ptrdiff_t>(bytes), vertices, kStreamDraw);
  if (indices == indices_) return;
  indices_ = std::move(indices);
  gl_.BufferData(kElementArrayBuffer, static_cast<std::ptrdiff_t>(indices_.size() * sizeof(std::uint32_t)),
                 indices_.data(), kStaticDraw);
}

void Triangles::draw(Enum mode, std::size_t count) const {
  gl_.BindVertexArray(array_);
  gl_.DrawElements(mode, static_cast<int>(count), kUnsignedInt, nullptr);
}

}  // namespace hair::gl
