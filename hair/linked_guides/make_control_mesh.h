// Makes the control mesh of guides as they lie at the start: the pairs of neighbours, the links between them,
// and the strips between them. Source: J. T. Chang, J. Jin, Y. Yu, "A Practical Model for Hair Mutual
// Interactions" (SCA 2002): strips lie between horizontal neighbours on a scalp, and between vertical ones
// too on a brush.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "hair/linked_guides/control_mesh.h"
#include "hair/mass_spring/strand_start.h"

namespace hair {

// A scalp uses rows, a brush uses both.
enum class Neighbours { rows, both };

using Pair = std::array<int, 2>;

// Guides grow in rows; row r holds the guides starts[r] to starts[r + 1] - 1, the last one those up to
// `guides` - 1. Each guide is the neighbour of the next one in its row, and with Neighbours::both of the one
// with the same place in the next row, if there is one.
std::vector<Pair> neighbours(const std::vector<int>& starts, int guides, Neighbours which);

struct MeshSpec {
  double stiffness = 0;           // N/m, of a link
  double yields = 1, breaks = 2;  // stretches, of a link
  std::optional<StripLaw> strips = {};
};

// A link from each particle of a pair's second guide, but its root, to the nearest particle of the first one.
// Its length is their distance, but at least that of a hair's width, 1e-4 m. A strip has two triangles
// between each two segments that have the same number.
ControlMesh control_mesh(std::span<const StrandStart> guides, std::span<const Pair> pairs,
                         const MeshSpec& spec);

}  // namespace hair
