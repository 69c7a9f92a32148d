// The scalp of a group's strands, for dense hair: its normals at their roots, and more roots on it.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "hair/scene/json/roots.h"

namespace hair::json {

struct GroupScalp {
  std::vector<RootFrame> guides;  // for each of the group's strands; axis: the scalp's normal
  bool combed = false;            // the sides of all roots are the directions in which hair is combed
  // Spreads roots evenly over the scalp; returns none if it has no area.
  std::function<std::vector<RootFrame>(int count, std::uint64_t seed)> more;
};

// The scalp of roots on a line, a disc, a cap or a bust, with `count` guides.
GroupScalp scalp_of(const Roots& roots, int count);

// The scalp of roots on an unknown surface. axis: the direction in which hair leaves its root.
GroupScalp scalp_of(const std::vector<RootFrame>& roots);

}  // namespace hair::json
