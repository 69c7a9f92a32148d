// Small differences between strands, from a seed: the same on every machine, which the standard library's
// distributions are not.
#pragma once

#include <cstdint>

#include "hair/strand/rest_shape.h"

namespace hair {

// Numbers that look random: G. Steele, D. Lea and C. Flood, "Fast Splittable Pseudorandom Number Generators"
// (OOPSLA 2014), SplitMix.
class Variation {
 public:
  explicit Variation(std::uint64_t seed) : state_(seed) {}

  double uniform(double low, double high);

 private:
  std::uint64_t state_;
};

// The frame, tilted by up to `tilt` and turned about its axis by up to `turn` (radians) either way.
RootFrame varied(const RootFrame& frame, double tilt, double turn, Variation& variation);

}  // namespace hair
