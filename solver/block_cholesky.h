// The Cholesky factorisation A = L L' of a symmetric, positive definite matrix with a narrow band of blocks.
// L has the same band, so that it replaces A in its memory. A factorisation and the two solves cost O(n).
// Source: G. H. Golub and C. F. Van Loan, "Matrix Computations" (4th edition, 2013), sections 4.2.5 and
// 4.3.5.
#pragma once

#include <Eigen/Core>

#include "solver/block_band.h"

namespace solver {

// Replaces A by L. The numbers on L's diagonal are stored as their reciprocals, since solves divide by them.
// Returns false at the first pivot that is not a number > 0: A is not positive definite, or not finite. The
// contents of `band` are then useless.
bool cholesky(BlockBand& band);

// x := L^-1 x and x := L^-T x, 3n numbers, with an L of `cholesky`. L^-T L^-1 b solves A x = b; the rounding
// errors are those of some A + E, |E| <= 10 u |L| |L'| entry by entry, u = 2^-53 (Golub and Van Loan, section
// 4.2.6: no row of L has more than nine numbers).
void solve_lower(const BlockBand& L, Eigen::Ref<Eigen::VectorXd> x);
void solve_lower_transposed(const BlockBand& L, Eigen::Ref<Eigen::VectorXd> x);

// The same for one block. The diagonal of L holds reciprocals here, too.
namespace block_cholesky {

bool factor(Eigen::Matrix3d& A);                                                        // A becomes L
Eigen::Vector3d divide(const Eigen::Matrix3d& L, const Eigen::Vector3d& b);             // L^-1 b
Eigen::Vector3d divide_transposed(const Eigen::Matrix3d& L, const Eigen::Vector3d& b);  // L^-T b

}  // namespace block_cholesky
}  // namespace solver
