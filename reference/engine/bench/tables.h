// STAFF ONLY. The tables of the engine's benchmark. Each prints its own, in Markdown.
#pragma once

#include "hair/head/groom.h"

namespace hair_bench {

// Costs (costs.cpp): of the engine's parts, beside given code; by the number of strands; by instruction set, and of two threads; what
// the machine can do.
void by_parts(int strands, const hair::Groom& grown);
void by_strands(const hair::Groom& grown);
void by_set(int strands, const hair::Groom& grown);
void by_peaks();

// Bullet's rope and plain XPBD (other_methods.cpp).
void beside_others();

// Errors (errors.cpp): by the step, and of a solve by its precision.
void by_step(const hair::Groom& grown);
void by_precision();

// What steps make of a small disturbance of curved hair, if they know no frames (curved_steps.cpp).
void by_curves();

}  // namespace hair_bench
