// Events of a control mesh since the start of a run. Equal runs have equal records.
#pragma once

#include <vector>

namespace hair {

struct BrokenLink {
  long step = 0;  // from 1: the step at whose end its stretch first reached the breaking one
  int link = 0;   // an index of ControlMesh::links

  bool operator==(const BrokenLink&) const = default;
};

struct MeshRecord {
  std::vector<BrokenLink> broken;  // ordered by steps, then by links
  double worn_off = 0;             // J: energy that links lost because they became weaker; if watched
};

}  // namespace hair
