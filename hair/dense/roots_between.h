// More roots on a scalp that is known only by its roots: spread evenly over the triangles between these. A
// triangle with a side three times as long as usual is no part of the scalp: it spans a bay of the hairline,
// or the way from ear to ear.
#pragma once

#include <cstdint>
#include <vector>

#include "hair/strand/rest_shape.h"

namespace hair {

// `count` roots; axis: the scalp's normal, as in `scalp`. A triangle's number of roots follows from its
// part of the area, rounded up or down, and the seed chooses their places in it. If the scalp has more than
// 20,000 roots, only every k-th one is a corner. Returns none for roots on one line.
std::vector<RootFrame> roots_between(const std::vector<RootFrame>& scalp, int count, std::uint64_t seed);

}  // namespace hair
