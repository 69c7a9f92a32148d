// Distributes any number of roots evenly over a scalp.
//
// The points of a Fibonacci lattice (R. Swinbank and R. J. Purser, "Fibonacci grids: A novel approach to
// global modelling", Quarterly Journal of the Royal Meteorological Society 132 (2006)) lie in a square; the
// inverses of the surface's cumulative areas bring them to a head's surface, so that equal areas have equal
// numbers of them. Points outside of the scalp are left out, and the seed moves each other point by up to a
// fifth of the usual distance.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "hair/head/head.h"
#include "hair/strand/rest_shape.h"

namespace hair {

class Scalp {
 public:
  // Keeps a reference to the head. Measures the surface once, which takes longer than making some thousand
  // roots.
  explicit Scalp(const Head& head);

  // `count` frames: axis is the surface's normal, side the combed direction. The same head, count and seed
  // give the same roots. Throws std::invalid_argument for a count below 0, and for a head without a scalp.
  std::vector<RootFrame> roots(int count, std::uint64_t seed) const;

  double area() const;  // m^2, to a percent

 private:
  class Areas;
  const Head& head_;
  std::shared_ptr<const Areas> areas_;
};

// The roots of a scalp that is needed only once.
inline std::vector<RootFrame> scalp_roots(const Head& head, int count, std::uint64_t seed) {
  return Scalp(head).roots(count, seed);
}

}  // namespace hair
