// Grows grooms on a head, from a seed.
//
// A strand's middle line starts at its root and goes on in small steps. Its direction turns, over the style's
// stiffness, from the root's to the combed one, and then down, or to the tie. The line keeps a distance from
// the head that grows at a slope of one half, up to a layer of hair. Strands of a clump approach the clump's
// own line towards their tips. Curls and waves wind about the middle line. The strand's points are at equal
// distances along it, and none of its pieces is inside the head.
#pragma once

#include <cstdint>

#include "hair/groom/groom.h"
#include "hair/head/hair_style.h"
#include "hair/head/head.h"

namespace hair {

struct GrowSettings {
  int strands = 10'000;
  int points = 0;  // per strand; 0: the style's number
  std::uint64_t seed = 1;
};

// In metres. Throws std::invalid_argument for a number of strands below 1, for fewer points than
// fewest_points, and for more than kMostGroomPoints in all.
Groom grow_groom(const Head& head, const HairStyle& style, const GrowSettings& settings);

}  // namespace hair
