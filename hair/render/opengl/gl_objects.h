// The objects of a context: programs, render targets, buffers of triangles. The context frees them when it
// ends, so there are no destructors here.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "hair/io/image/image.h"
#include "hair/render/opengl/gl.h"
#include "hair/render/opengl/shaders.h"

namespace hair::gl {

class Program {
 public:
  // Throws std::runtime_error with the compiler's message. `header` is inserted before both shaders.
  Program(const Functions& functions, Pass pass, const std::string& header);

  void use() const { gl_.UseProgram(name_); }

  // Sets uniforms of the program that is in use; ignores a name that its shaders do not use.
  void set(const char* name, float value) const;
  void set(const char* name, float x, float y) const;
  void set(const char* name, const Eigen::Vector3f& value) const;
  void set(const char* name, const Eigen::Vector4f& value) const;
  void set(const char* name, const Eigen::Matrix4f& value) const;
  void set(const char* name, int unit, Name texture) const;

 private:
  int uniform(const char* name) const { return gl_.GetUniformLocation(name_, name); }
  Name compile(Enum kind, const std::string& text) const;

  const Functions& gl_;
  Name name_;
};

// Programs of a context, each compiled when it is first needed.
class Programs {
 public:
  explicit Programs(const Functions& functions) : gl_(functions) {}

  // Compiles, if needed, and uses the program of this pass with this header.
  const Program& use(Pass pass, const std::string& header = "") {
    const Program& program = programs_.try_emplace({pass, header}, gl_, pass, header).first->second;
    program.use();
    return program;
  }

 private:
  const Functions& gl_;
  std::map<std::pair<Pass, std::string>, Program> programs_;
};

// A render target that can be read as a texture: colours, depths, or both.
struct Target {
  Name framebuffer = 0, colour = 0, depth = 0;
  int width = 0, height = 0;
};

// `colour_format` 0: no colours. `depth`: the depth texture to use, for example another target's; 0: a new
// one.
Target make_target(const Functions& gl, int width, int height, Enum colour_format, bool with_depth,
                   Name depth = 0);
void draw_into(const Functions& gl, const Target& target);
std::vector<float> depths_of(const Functions& gl, const Target& target);  // the lowest row first
Image image_of(const Functions& gl, const Target& target);

// Numbers calculated by a program, one or four for each texel.
class FloatTexture {
 public:
  explicit FloatTexture(const Functions& functions);

  // values: row after row, the lowest first.
  void send(int width, int height, int channels, const float* values);
  Name name() const { return name_; }

 private:
  const Functions& gl_;
  Name name_ = 0;
};

// Triangles: vertices of floats, and indices. Sends the indices again only if they changed.
class Triangles {
 public:
  // `attributes`: the number of floats of each vertex attribute.
  Triangles(const Functions& functions, const std::vector<int>& attributes);

  void send(const void* vertices, std::size_t bytes, std::vector<std::uint32_t> indices);
  void draw(Enum mode, std::size_t count) const;
  std::size_t size() const { return indices_.size(); }

 private:
  const Functions& gl_;
  Name array_ = 0, buffers_[2] = {0, 0};
  std::vector<std::uint32_t> indices_;
};

}  // namespace hair::gl
