// Given. A preconditioner for H4's system: a matrix M near A that is quickly factored, M = L L'. Conjugate gradients
// need few iterations where a matrix is near the identity, and L^-1 A L^-T is. So instead of A x = b one solves
//
//   (L^-1 A L^-T) y = L^-1 b,   x = L^-T y.
//
// Source: G. H. Golub and C. F. Van Loan, "Matrix Computations" (4th edition, 2013), section 11.5.
//
// M is A with the forces' local, definite products (Force::add_band): M - a df/dv - a b df/dx is then a narrow band,
// and its factor costs as much as some iterations. Of straight hair with definite products M = A.
#pragma once

#include <algorithm>
#include <cmath>

#include "particles/force.h"
#include "particles/state.h"
#include "solver/block_band.h"
#include "solver/block_cholesky.h"
#include "solver/linearSolver.h"

namespace particles {

// `scratch` has this many columns of 3n numbers.
inline constexpr int kPreconditionerScratch = solver::BlockBand::kColumns + 2;

class Preconditioner {
 public:
  // For implicit_matrix(force, particles, state, a, b): builds M and factors it. Keeps L in `scratch`, which must stay
  // untouched as long as this object is used. Allocates nothing.
  Preconditioner(const Force& force, const Particles& particles, const State& state, double a, double b,
                 Scratch scratch);

  // False: there is none, because a force does not know its band, its products are not symmetric, or M is not positive
  // definite. Then ConjGrad solves A x = b as it is, and the functions below must not be called.
  bool exists() const { return exists_; }

  // An upper bound of the norm of M's rows of free particles, the largest sum of |m_ij| in one of them. A pinned
  // particle's 1 does not count: very light hair has rows of 1e-12.
  double norm() const { return norm_; }

  // Whether a residual is as small as rounding lets it be: at most 32 u (norm ||x|| + ||b||), u = 2^-53. Each number of
  // A x is a sum of 15 products, and a force takes about as many roundings again to make each of them.
  bool rounding_allows(double residual, double norm_of_x, double norm_of_b) const {
    return residual <= 0x1p-48 * (norm_ * norm_of_x + norm_of_b);
  }

  // x := L^-1 x and x := L^-T x, 3n numbers.
  void solve_lower(Output x) const;
  void solve_lower_transposed(Output x) const;

 private:
  solver::BlockBand band_;
  bool exists_;
  double norm_ = 0;
};

// L^-1 A L^-T. Keeps references to A and the preconditioner, and uses `work`, 3n numbers. A product takes one with A.
class PreconditionedMatrix : public implicitMatrix {
 public:
  PreconditionedMatrix(implicitMatrix& A, const Preconditioner& preconditioner, Output work)
      : A_(A), preconditioner_(preconditioner), work_(work) {}

  void matVecMult(double x[], double b[]) override;

 private:
  implicitMatrix& A_;
  const Preconditioner& preconditioner_;
  Output work_;
};

namespace preconditioner {

inline void clear_row_and_column(int i, solver::BlockBand& band) {
  for (int back = 0; back <= std::min(solver::BlockBand::kReach, i); ++back) band.block(i, back).setZero();
  for (int below = 1; below <= std::min(solver::BlockBand::kReach, band.rows() - 1 - i); ++below)
    band.block(i + below, below).setZero();
}

// M; pinned particles have rows and columns of 0.
inline bool assemble(const Force& force, const Particles& particles, const State& state, double a, double b,
                     Scratch work, solver::BlockBand& band) {
  band.set_zero();
  if (!force.add_band(state.x, state.v, -a * b, -a, band, work)) return false;
  for (int i = 0; i < particles.count(); ++i)
    if (particles.is_pinned(i))
      clear_row_and_column(i, band);
    else
      band.block(i, 0).diagonal().array() += particles.mass[i];
  return true;
}

// Then pinned particles have rows and columns of the identity.
inline void add_identity_of_pinned(const Particles& particles, solver::BlockBand& band) {
  for (int i = 0; i < particles.count(); ++i)
    if (particles.is_pinned(i)) band.block(i, 0).setIdentity();
}

}  // namespace preconditioner

inline Preconditioner::Preconditioner(const Force& force, const Particles& particles, const State& state,
                                      double a, double b, Scratch scratch)
    : band_(scratch.leftCols(solver::BlockBand::kColumns)),
      exists_(preconditioner::assemble(force, particles, state, a, b,
                                       scratch.middleCols(solver::BlockBand::kColumns, kBandScratch),
                                       band_)) {
  if (!exists_) return;
  norm_ = band_.norm();
  preconditioner::add_identity_of_pinned(particles, band_);
  exists_ = std::isfinite(norm_) && solver::cholesky(band_);
}

inline void Preconditioner::solve_lower(Output x) const {
  solver::solve_lower(band_, x);
}

inline void Preconditioner::solve_lower_transposed(Output x) const {
  solver::solve_lower_transposed(band_, x);
}

inline void PreconditionedMatrix::matVecMult(double x[], double b[]) {
  const Eigen::Index size = work_.size();
  Eigen::Map<Eigen::VectorXd> product(b, size);
  work_ = Eigen::Map<const Eigen::VectorXd>(x, size);
  preconditioner_.solve_lower_transposed(work_);
  A_.matVecMult(work_.data(), b);
  preconditioner_.solve_lower(product);
}

}  // namespace particles
