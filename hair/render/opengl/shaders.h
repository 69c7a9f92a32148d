// The shaders, GLSL 3.30. A header before each defines HAIR_SHADOWS, SOLID_SHADOWS, both or none.
#pragma once

#include <string>

namespace hair {

struct ShaderPair {
  std::string vertex, fragment;
};

enum class Pass {
  ribbon,        // hair, from the camera
  mesh,          // everything except hair, from the camera
  ribbon_depth,  // hair, from the light: its depth,
  ribbon_count,  //   and the number of strands behind one another
  mesh_depth,    // everything except hair, from the light
  resolve        // samples to pixels
};

const ShaderPair& shaders_of(Pass pass);

}  // namespace hair
