// What lives in a context: programs, pictures to draw into, buffers of triangles. A context that ends takes
// them with it, so nothing here is given back one by one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "hair/render/gl.h"
#include "hair/render/shaders.h"

namespace hair::gl {

class Program {
 public:
  // Throws std::runtime_error with the compiler's words. `header` stands before both shaders.
  Program(const Functions& functions, const ShaderPair& shaders, const std::string& header = "");

  void use() const { gl_.UseProgram(name_); }
  int uniform(const char* name) const { return gl_.GetUniformLocation(name_, name); }

 private:
  Name compile(Enum kind, const std::string& text) const;

  const Functions& gl_;
  Name name_;
};

// What is drawn into, and read as a texture: colours, depths, or both.
struct Target {
  Name framebuffer = 0, colour = 0, depth = 0;
  int width = 0, height = 0;
};

// `colour_format` 0: no colours. `depth`: a texture to use, that of another target if one is given; 0: a new
// one.
Target make_target(const Functions& gl, int width, int height, Enum colour_format, bool with_depth,
                   Name depth = 0);
void draw_into(const Functions& gl, const Target& target);

// Triangles: vertices of floats, and indices, which are sent anew only if they changed.
class Triangles {
 public:
  // The numbers of floats that belong to each attribute of a vertex.
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
