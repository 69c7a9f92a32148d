// STAFF ONLY. Problems whose motions are known or quick to compute.
#pragma once

#include "hair/truth/accurate_motion.h"

namespace reference_tests {

// 6 cm of hair in 6 segments, EA and EI `factor` times those of hair, horizontal at a hinge, for 0.1 s.
hair::Problem level_strand(double factor = 1e-3);

// A strand whose root two motions move and turn one after the other, with keys within the 0.1 s.
hair::Problem carried_strand(double factor = 1e-3);

// Without interruption and without a cache.
hair::AccurateMotion motion_of(const hair::Problem& problem, double tolerance = hair::kTightest);

}  // namespace reference_tests
