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

struct BrokenLink {
  long step = 0;  // from 1: the step at whose end its stretch first reached the breaking one
  int link = 0;   // an index of ControlMesh::links

  bool operator==(const BrokenLink&) const = default;
};

// Events of a control mesh since the start of a run. Equal runs have equal records.
struct MeshRecord {
  std::vector<BrokenLink> broken;  // ordered by steps, then by links
  double worn_off = 0;             // J: energy that links lost because they became weaker; if watched
};

}  // namespace hair
