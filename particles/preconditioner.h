// Given. A preconditioner for H4's system: a matrix M near A that is quickly factored, M = L L'. Conjugate
// gradients need few iterations if a matrix is near the identity, as L^-1 A L^-T is. So instead of A x = b
// one solves
//
//   (L^-1 A L^-T) y = L^-1 b,   x = L^-T y.
//
// Source: G. H. Golub and C. F. Van Loan, "Matrix Computations" (4th edition, 2013), section 11.5.
//
// M is A with the forces' local, definite products (Force::add_band): M - a df/dv - a b df/dx is then a
// narrow band, and its factor costs as much as some iterations. For straight hair with definite products M
// equals A.
#pragma once

#include "particles/force.h"
#include "particles/state.h"
#include "solver/block_band.h"
#include "solver/linearSolver.h"

namespace particles {

// `scratch` has this many columns of 3n numbers.
inline constexpr int kPreconditionerScratch = solver::BlockBand::kColumns + kBandScratch;

class Preconditioner {
 public:
  // For implicit_matrix(force, particles, state, a, b): builds M and factors it. Keeps L in `scratch`, which
  // must stay untouched as long as this object is used. Allocates nothing.
  Preconditioner(const Force& force, const Particles& particles, const State& state, double a, double b,
                 Scratch scratch);

  // False if a force has no band, its products are not symmetric, or M is not positive definite. Then
  // ConjGrad solves A x = b as it is, and the functions below must not be called.
  bool exists() const { return exists_; }

  // An upper bound of the norm of M's rows of free particles, the largest sum of |m_ij| in one of them. A
  // pinned particle's 1 does not count: very light hair has rows of 1e-12.
  double norm() const { return norm_; }

  // True if a residual is as small as rounding allows: at most 32 u (norm ||x|| + ||b||), u = 2^-53. Each
  // number of A x is a sum of 15 products, and a force rounds about as many times to calculate each of these.
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

// L^-1 A L^-T. Keeps references to A and the preconditioner, and uses `work`, 3n numbers. A product takes one
// with A.
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

}  // namespace particles
