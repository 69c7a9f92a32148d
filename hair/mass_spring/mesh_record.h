// What happened to a control mesh since the start of a run. Equal runs have equal records.
#pragma once

#include <vector>

namespace hair {

struct BrokenLink {
  long step = 0;  // from 1: the step at whose end its stretch was first at least what breaks it
  int link = 0;   // of ControlMesh::links

  bool operator==(const BrokenLink&) const = default;
};

struct MeshRecord {
  std::vector<BrokenLink> broken;  // by steps, then by links
  double worn_off = 0;             // J: what links held, and no longer hold since they are weaker; if watched
};

}  // namespace hair
