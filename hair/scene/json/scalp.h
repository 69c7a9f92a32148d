// Where a group's strands grow, as dense hair needs it: the scalp at their roots, and more roots on it.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "hair/scene/json/roots.h"

namespace hair::json {

struct GroupScalp {
  std::vector<RootFrame> guides;  // of each of the group's strands; axis: the scalp's normal
  bool combed = false;            // the sides of all roots are how hair is combed there
  // Evenly over the scalp; none if it has no area.
  std::function<std::vector<RootFrame>(int count, std::uint64_t seed)> more;
};

// The scalp of roots on a line, a disc, a cap or a bust, with `count` guides.
GroupScalp scalp_of(const Roots& roots, int count);

// That of roots on a surface which nothing else tells. axis: how hair leaves its root.
GroupScalp scalp_of(const std::vector<RootFrame>& roots);

}  // namespace hair::json
