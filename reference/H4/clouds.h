// STAFF ONLY. Particles under forces whose parts can be left out one by one, and soft hair.
#pragma once

#include "grader/judge/cases/implicit_system.h"

namespace grader::h4 {

// The derivatives that a force has. Even with none it still has a force.
enum class Parts { none, dfdx, dfdv, all };

// n particles of 0.4 to 3 kg whose df/dx and df/dv depend on places and velocities.
Cloud mixed_cloud(Random& random, int n, Parts parts);
Cloud with(Cloud cloud, Parts parts);

// n free particles of about 1 kg in a chain of springs with h^2 k/m = 0.1. With `banded` the force knows its
// band.
Cloud soft_hair(Random& random, int n, double h, bool banded);

}  // namespace grader::h4
