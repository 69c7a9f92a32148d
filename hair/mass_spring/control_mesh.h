// A control mesh: links and triangle strips between guides of masses and springs. Particles are counted
// through all strands: those of strand 0, of strand 1, ... Source: the lecture, "Control Mesh".
#pragma once

#include <array>
#include <vector>

#include "hair/static_link.h"

namespace hair {

// Between two guides. All its triangles turn the same way.
struct MeshStrip {
  std::array<int, 2> guides;
  std::vector<std::array<int, 3>> triangles;
};

struct ControlMesh {
  std::vector<StaticLink> links;
  std::vector<MeshStrip> strips;
  StripLaw law;  // of all strips
};

}  // namespace hair
