// Conjugate gradients with a preconditioner: the same solver on L^-1 A L^-T, whose eigenvalues are nearer to
// each other. Source: Golub and Van Loan, "Matrix Computations", 4th edition, section 11.5.
#pragma once

#include "solver/study/banded_cholesky.h"
#include "solver/study/history.h"

namespace solver::study {

// Solves Ax = b as L^-1 A L^-T y = L^-1 b, x = L^-T y, where L L' = `near`, a banded matrix near A. Each call
// factors it, so that the time of the factorisation counts. Epsilon bounds ||L^-1 (b - Ax)||^2. The function
// returns NaN, because the solver does not compute ||b - Ax||^2. `near` must outlive the function.
ConjGradFunction preconditioned(const ConjGradFunction& solve, BandedCholesky& near);

}  // namespace solver::study
