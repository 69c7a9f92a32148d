// Small random differences between strands, from a seed. They are the same on every machine, unlike those of
// the standard library's distributions.
#pragma once

#include <cstdint>

#include "hair/strand/rest_shape.h"

namespace hair {

// Pseudo-random numbers: G. Steele, D. Lea and C. Flood, "Fast Splittable Pseudorandom Number Generators"
// (OOPSLA 2014), SplitMix.
class Variation {
 public:
  explicit Variation(std::uint64_t seed) : state_(seed) {}

  // One of many independent sequences of a seed: a strand's sequence does not depend on the number or the
  // order of the other strands.
  Variation(std::uint64_t seed, std::uint64_t sequence);

  double uniform(double low, double high);

 private:
  std::uint64_t state_;
};

// The frame, tilted by up to `tilt` and turned about its axis by up to `turn` radians in either direction.
RootFrame varied(const RootFrame& frame, double tilt, double turn, Variation& variation);

}  // namespace hair
