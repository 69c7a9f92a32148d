// STAFF ONLY. H3's functions, and strands of its hidden cases. Bounds: suite/strand_springs.h.
#pragma once

#include "grader/judge/strand_springs.h"
#include "hair/bend_springs.h"
#include "reference/H3/calls.h"

namespace grader::h3 {

using Bend = SpringForce<Calls, hair::bend_spring_energy, hair::add_bend_spring_force,
                         hair::add_bend_spring_product, &Strand::skip_rigidity, 2>;

// Springs whose rest length is 1 m: what k is made of is another category's.
inline Strand half_metres(Random& random, int count) {
  Strand strand = toy_strand(random, count);
  strand.rest_length.setConstant(0.5);
  return strand;
}

inline constexpr Range kStretch = {0.6, 1.5}, kLong = {2, 3}, kBend = {0.1, 2.2};

}  // namespace grader::h3
