// STAFF ONLY. Problems whose motions are known, or quick to find.
#pragma once

#include "hair/truth/accurate_motion.h"

namespace reference_tests {

// 6 cm of hair in 6 segments, EA and EI times `factor` those of hair, level at a hinge, for 0.1 s.
hair::Problem level_strand(double factor = 1e-3);

// Its root carried along and turned by two motions after each other, with keys inside of the 0.1 s.
hair::Problem carried_strand(double factor = 1e-3);

// Without being interrupted, and not kept.
hair::AccurateMotion motion_of(const hair::Problem& problem, double tolerance = hair::kTightest);

}  // namespace reference_tests
