// Finds the guides between which a child grows: a strand that is made of guides. Found once, along the scalp.
#pragma once

#include <array>
#include <vector>

#include "hair/dense/scalp_map.h"

namespace hair {

// The three guides of a child, with their weights. If two guides are the same, or weights are 0, it has
// fewer. The nearest guide comes first: the child is in its wisp.
struct Parents {
  std::array<int, 3> guides;
  std::array<double, 3> weights;
};

// Finds for each child the triangle of guides that holds its root, in a triangulation of the guides' roots on
// the map; guides on a line have two neighbours at most. Needs at least one guide. Calls root_weights (H10)
// for each child.
std::vector<Parents> find_parents(const ScalpMap& map, const std::vector<RootFrame>& guides,
                                  const std::vector<RootFrame>& children);

// Hair is combed to both sides of a parting, and no hair grows between the two sides. A guide combed against
// the child's own direction gives its weight to the others, or, if there are none, to the nearest guide that
// is not combed against it. The `side` of each root is the direction in which hair is combed there.
void keep_to_side_of_parting(const std::vector<RootFrame>& guides, const std::vector<RootFrame>& children,
                             std::vector<Parents>& parents);

}  // namespace hair
