// STAFF ONLY. A chain of springs as stiff as hair whose force knows its band.
#pragma once

#include "grader/suite/implicit_system.h"

namespace grader::h4 {

// n particles, the root pinned, along a chain of about 1 cm that bends a little. Springs along it, h^2 k/m from 1e4 to 1e6,
// and weaker ones that skip a particle. With `far`, another spring holds the tip to the particle below the root, and the
// band does not know of it.
Cloud stiff_hair(Random& random, int n, double h, bool far);

}  // namespace grader::h4
