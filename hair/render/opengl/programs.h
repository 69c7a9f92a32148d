// Programs of a context, each compiled when it is first needed.
#pragma once

#include <map>
#include <string>

#include "hair/render/opengl/gl_objects.h"

namespace hair {

class Programs {
 public:
  explicit Programs(const gl::Functions& functions) : gl_(functions) {}

  // Compiles, if needed, and uses the program of these shaders with this header.
  const gl::Program& use(const std::string& name, ShaderPair (*shaders)(), const std::string& header = "") {
    auto place = programs_.find(name + header);
    if (place == programs_.end()) place = programs_.try_emplace(name + header, gl_, shaders(), header).first;
    place->second.use();
    return place->second;
  }

 private:
  const gl::Functions& gl_;
  std::map<std::string, gl::Program> programs_;
};

}  // namespace hair
