// The shaders, GLSL 3.30. Each begins after a header that says which of HAIR_SHADOWS and SOLID_SHADOWS there
// are.
#pragma once

#include <string>

namespace hair {

struct ShaderPair {
  std::string vertex, fragment;
};

ShaderPair ribbon_shader();        // hair, as the camera sees it
ShaderPair mesh_shader();          // all that is not hair, as the camera sees it
ShaderPair ribbon_depth_shader();  // hair as the light sees it: how near,
ShaderPair ribbon_count_shader();  //   and how many strands one behind the other
ShaderPair mesh_depth_shader();    // the rest as the light sees it
ShaderPair resolve_shader();       // samples to pixels

}  // namespace hair
