#include "particles/preconditioner.h"

#include <algorithm>
#include <cmath>

#include "solver/block_cholesky.h"

namespace particles {
namespace {

void clear_row_and_column(int i, solver::BlockBand& band) {
  for (int back = 0; back <= std::min(solver::BlockBand::kReach, i); ++back) band.block(i, back).setZero();
  for (int below = 1; below <= std::min(solver::BlockBand::kReach, band.rows() - 1 - i); ++below)
    band.block(i + below, below).setZero();
}

// M; pinned particles have rows and columns of 0.
bool assemble(const Force& force, const Particles& particles, const State& state, double a, double b,
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
void add_identity_of_pinned(const Particles& particles, solver::BlockBand& band) {
  for (int i = 0; i < particles.count(); ++i)
    if (particles.is_pinned(i)) band.block(i, 0).setIdentity();
}

}  // namespace

Preconditioner::Preconditioner(const Force& force, const Particles& particles, const State& state, double a,
                               double b, Scratch scratch)
    : band_(scratch.leftCols(solver::BlockBand::kColumns)),
      exists_(assemble(force, particles, state, a, b,
                       scratch.middleCols(solver::BlockBand::kColumns, kBandScratch), band_)) {
  if (!exists_) return;
  norm_ = band_.norm();
  add_identity_of_pinned(particles, band_);
  exists_ = std::isfinite(norm_) && solver::cholesky(band_);
}

void Preconditioner::solve_lower(Output x) const {
  solver::solve_lower(band_, x);
}

void Preconditioner::solve_lower_transposed(Output x) const {
  solver::solve_lower_transposed(band_, x);
}

void PreconditionedMatrix::matVecMult(double x[], double b[]) {
  const Eigen::Index size = work_.size();
  Eigen::Map<Eigen::VectorXd> product(b, size);
  work_ = Eigen::Map<const Eigen::VectorXd>(x, size);
  preconditioner_.solve_lower_transposed(work_);
  A_.matVecMult(work_.data(), b);
  preconditioner_.solve_lower(product);
}

}  // namespace particles
