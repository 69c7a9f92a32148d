// Which guides a child, a strand that is made of guides, grows between. Found once, along the scalp.
#pragma once

#include <array>
#include <vector>

#include "hair/head/scalp_map.h"

namespace hair {

// The three guides of a child, with their weights; where two are the same, or the weights 0, it has fewer.
// The one that is nearest comes first: the child is in its wisp.
struct Parents {
  std::array<int, 3> guides;
  std::array<double, 3> weights;
};

// Of each child the triangle of guides that holds its root, in a triangulation of the guides' roots on the
// map; guides on a line have two neighbours at most. At least one guide. Calls root_weights (H10) for each
// child.
std::vector<Parents> find_parents(const ScalpMap& map, const std::vector<RootFrame>& guides,
                                  const std::vector<RootFrame>& children);

// Hair is combed to both sides of a parting, and none grows between the two. The weights of guides that are
// combed against the child's own direction go to the others; if there are none, all goes to the nearest guide
// that is not. Of all roots, side: how hair is combed there.
void keep_to_side_of_parting(const std::vector<RootFrame>& guides, const std::vector<RootFrame>& children,
                             std::vector<Parents>& parents);

}  // namespace hair
