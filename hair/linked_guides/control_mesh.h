// A control mesh: links and triangle strips between guides of masses and springs. Particles are numbered
// through all strands: strand 0 first, then strand 1, ... Source: the lecture, "Control Mesh".
#pragma once

#include <array>
#include <vector>

#include "hair/static_link.h"

namespace hair {

// A strip between two guides. All its triangles turn the same way.
struct MeshStrip {
  std::array<int, 2> guides;
  std::vector<std::array<int, 3>> triangles;
};

struct ControlMesh {
  std::vector<StaticLink> links;
  std::vector<MeshStrip> strips;
  StripLaw law;  // shared by all strips
};

}  // namespace hair
