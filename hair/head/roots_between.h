// More roots on a scalp that only its roots tell: evenly over the triangles between them. A triangle with a
// side that is thrice as long as usual is no part of the scalp: it goes over a bay of the hairline, or from
// ear to ear.
#pragma once

#include <cstdint>
#include <vector>

#include "hair/strand/rest_shape.h"

namespace hair {

// `count` roots; axis: the scalp's normal, as in `scalp`. A triangle gets as many as its share of the area
// says, to one, and the seed chooses where they are in it. Of more than 20,000 roots of the scalp every so
// many are corners. None for roots that are on one line.
std::vector<RootFrame> roots_between(const std::vector<RootFrame>& scalp, int count, std::uint64_t seed);

}  // namespace hair
