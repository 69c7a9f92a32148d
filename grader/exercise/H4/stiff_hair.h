// STAFF ONLY. A chain of springs as stiff as hair whose force knows its band.
#pragma once

#include "grader/suite/implicit_system.h"

namespace grader::h4 {

// n particles, the root pinned, along a chain of about 1 cm that bends a little. Springs along it, h^2 k/m from 1e4 to 1e6,
// and weaker ones that skip a particle. `far` more
// springs hold the tip, and those above it, to particles below the root, and the band does not know of them. The drag takes `drag` times
// a particle's momentum within h.
Cloud stiff_hair(Random& random, int n, double h, int far, double drag = 0);

// Such a hair of six particles whose band knows of no spring, with masses of 1:1e6 and h^2 k/m of 1e4: a preconditioner
// that is far from the matrix.
Cloud hair_without_band(Random& random, double h);

// Six particles with springs two to three times as long as they are let be, h^2 k/m = 1e4, and a band that knows of none: the
// matrix has negative eigenvalues, and the preconditioner is positive definite.
Cloud compressed_without_band(Random& random, double h);

// n particles with a spring between any two, h^2 k/m from 1 to 1e6, and a band that knows of none.
Cloud tangle_without_band(Random& random, int n, double h);

// The same hair with masses times `mass`, lengths and velocities times `length`; times are the same.
Cloud in_other_units(const Cloud& hair, double mass, double length);

// A hair under gravity, h^2 k/m = `stiff`, no spring stretched; its force does not know the band. Rounding leaves a
// residual of about u `stiff` times the right-hand side.
Cloud hanging_hair(Random& random, int n, double stiff, double h);
// The same, and the force knows it.
Cloud hanging_hair_with_band(Random& random, int n, double stiff, double h);

}  // namespace grader::h4
