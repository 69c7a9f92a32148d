// The shaders, GLSL 3.30. A header before each defines HAIR_SHADOWS, SOLID_SHADOWS, both or none.
#pragma once

#include <string>

namespace hair {

struct ShaderPair {
  std::string vertex, fragment;
};

ShaderPair ribbon_shader();        // hair, from the camera
ShaderPair mesh_shader();          // everything except hair, from the camera
ShaderPair ribbon_depth_shader();  // hair, from the light: its depth,
ShaderPair ribbon_count_shader();  //   and the number of strands behind one another
ShaderPair mesh_depth_shader();    // everything except hair, from the light
ShaderPair resolve_shader();       // samples to pixels

}  // namespace hair
