// Strands from what they are made of. Masses: each segment, line_density * rest length, gives half of its
// mass to either end, so that the root and the tip have half of what the particles between them have.
#pragma once

#include "hair/strand.h"
#include "hair/strand/material.h"
#include "particles/vectors.h"

namespace hair {

// A strand of `segments` segments of length / segments each. segments >= 1, length > 0 (m).
//
// Both functions fill in mass, rest_length, stretch_rigidity and bend_rigidity; the strand is a hinge at its
// root and has no springs that skip a particle. They throw std::invalid_argument for what is out of bounds,
// not finite, or too light to be a normal number of kg.
Strand uniform_strand(const Material& material, int segments, double length);

// A strand that is at rest in x (3n, m; n >= 1): rest lengths are the distances of neighbours, which must be
// > 0. A lone particle has no segment to take its mass from: it weighs what a ball of the fibre's radius
// does.
Strand strand_from_rest(const Material& material, particles::Input x);

}  // namespace hair
