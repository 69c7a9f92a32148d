// STAFF ONLY. H1's functions, and strands of its hidden cases. Bounds: suite/strand_springs.h.
#pragma once

#include "grader/judge/strand_springs.h"
#include "hair/stretch_springs.h"
#include "reference/H1/calls.h"

namespace grader::h1 {

using Stretch = SpringForce<Calls, hair::stretch_energy, hair::add_stretch_force, hair::add_stretch_product,
                            &Strand::stretch_rigidity, 1>;

inline constexpr Range kStretched = {1.05, 1.8}, kCompressed = {0.3, 0.95}, kMixed = {0.5, 1.6},
                       kToOnePercent = {0.01, 0.012}, kAnyBend = {0.1, 2.8};

}  // namespace grader::h1
