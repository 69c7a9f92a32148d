// Given. Solves the system of particles/implicit_euler.h, (M - a df/dv - a b df/dx) dv = a (f + b df/dx v),
// as quickly as the forces allow. It is compiled into each file that calls it, because it calls exercises:
// implicit_matrix, implicit_rhs and solve_plain (H4), and ConjGrad (S1).
//
// With a preconditioner (particles/preconditioner.h) dv starts at 0. Each solve takes the residual r = rhs -
// matrix dv, solves (L^-1 matrix L^-T) y = L^-1 r, and adds L^-T y to dv. ConjGrad sees the norm of L^-1 r,
// but the tolerance bounds the norm of r, so r is computed anew after each solve. There are at most three
// solves, until the residual reaches the tolerance, rounding allows no less, or it no longer falls.
//
// Without a preconditioner, solve_plain solves. Rounding limits the tolerance that a stiff system can reach:
// it leaves a residual of about 2^-53 ||matrix|| (||dv|| + ||rhs||). For a smaller tolerance, ConjGrad uses
// all iterations and ends anywhere, metres per second off. So solve_plain is then called again with a
// tolerance a hundred times as large, up to 1e-6: at 1e-4 hair loses gravity. `converged` stays false.
#pragma once

#include <algorithm>
#include <cmath>

#include "particles/implicit_euler.h"

namespace particles {

// With a preconditioner, the system is solved at most this often, each time for the remaining residual.
inline constexpr int kMostSolves = 3;

namespace solving {

inline constexpr double kLoosestTolerance = 1e-6, kTightestTolerance = 1e-14;

inline SolveReport without_preconditioner(implicitMatrix& matrix, Output rhs, double tolerance, Output dv) {
  const int most = std::max(100, 20 * static_cast<int>(rhs.size()));
  int steps = 0;
  for (double reach = tolerance;; reach = std::clamp(100 * reach, kTightestTolerance, kLoosestTolerance)) {
    SolveReport report = solve_plain(matrix, rhs, reach, most, dv);
    const bool used_up = report.steps >= most && !report.converged;
    steps += report.steps;
    if (!used_up || reach >= kLoosestTolerance) {
      report.steps = steps;
      report.converged = report.converged && reach == tolerance;
      return report;
    }
  }
}

// `work` has three columns.
inline SolveReport with_preconditioner(implicitMatrix& matrix, const Preconditioner& preconditioner,
                                       Input rhs, double tolerance, Output dv, Scratch work) {
  const int size = static_cast<int>(rhs.size());
  auto left = work.col(0), y = work.col(1);
  PreconditionedMatrix near_identity(matrix, preconditioner, work.col(2));
  SolveReport report;
  report.preconditioned = true;
  report.rhs = report.residual = rhs.norm();
  dv.setZero();
  left = rhs;
  for (int solve = 0; solve < kMostSolves && !report.converged; ++solve) {
    preconditioner.solve_lower(left);
    int steps = std::max(100, size);
    const double epsilon = std::pow(std::max(tolerance, kTightestTolerance) * left.norm(), 2);
    ConjGrad(size, &near_identity, y.data(), left.data(), epsilon, &steps);
    report.steps += steps;
    preconditioner.solve_lower_transposed(y);
    dv += y;
    matrix.matVecMult(dv.data(), left.data());
    left = rhs - left;
    const double residual = left.norm();
    if (!(residual < report.residual || residual == 0)) {  // the solve made the residual no smaller
      dv -= y;
      break;
    }
    report.residual = residual;
    report.converged =
        residual <= tolerance * report.rhs || preconditioner.rounding_allows(residual, dv.norm(), report.rhs);
  }
  return report;
}

}  // namespace solving

// `converged` means residual <= tolerance * rhs, or, with a preconditioner, that rounding allows no less. The
// report's steps are those of all calls of ConjGrad together.
inline SolveReport solve_implicit(const Force& force, const Particles& particles, const State& state,
                                  double a, double b, double tolerance, Output dv, Scratch scratch) {
  auto rhs = scratch.col(0);
  implicit_rhs(force, particles, state, a, b, rhs);
  const std::unique_ptr<implicitMatrix> matrix = implicit_matrix(force, particles, state, a, b);
  const Preconditioner preconditioner(force, particles, state, a, b,
                                      scratch.middleCols(4, kPreconditionerScratch));
  if (!preconditioner.exists()) return solving::without_preconditioner(*matrix, rhs, tolerance, dv);
  return solving::with_preconditioner(*matrix, preconditioner, rhs, tolerance, dv, scratch.middleCols(1, 3));
}

}  // namespace particles
