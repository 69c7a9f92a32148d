// Makes strands from a material. Masses: each segment, line_density * rest length, gives half of its mass to
// either end, so that the root and the tip have half the mass of the particles between them.
#pragma once

#include "hair/strand.h"
#include "hair/strand/material.h"
#include "particles/vectors.h"

namespace hair {

// A strand of `segments` segments of length / segments each. segments >= 1, length > 0 (m).
//
// Both functions fill in mass, rest_length, stretch_rigidity and bend_rigidity; the strand is a hinge at its
// root and has no springs that skip a particle. They throw std::invalid_argument for values that are out of
// bounds, not finite, or so small that a mass is not a normal number.
Strand uniform_strand(const Material& material, int segments, double length);

// A strand whose rest shape is x (3n, m; n >= 1): rest lengths are the distances of neighbours, which must be
// > 0. A single particle has no segment that gives it mass: it has the mass of a ball with the fibre's
// radius.
Strand strand_from_rest(const Material& material, particles::Input x);

}  // namespace hair
