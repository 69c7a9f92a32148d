// STAFF ONLY. H5: the non-linear post correction.

#include "hair/length_correction.h"

#include <algorithm>
#include <cmath>

namespace hair {
namespace {

using Eigen::Vector3d;

Vector3d segment(Input x, int i) {
  return x.segment<3>(3 * i + 3) - x.segment<3>(3 * i);
}

// The unit vector along e, or the direction of the segment before if e is 0.
Vector3d direction(const Vector3d& e, const Vector3d& before) {
  const double length = e.norm();
  return length > 0 ? Vector3d(e / length) : before;
}

// 1/mass of particle i; the root is infinitely heavy.
double inverse_mass(const Strand& strand, int i) {
  return i == 0 ? 0 : 1 / strand.mass[i];
}

// |l - l0| / l0 of the worst segment, or NaN if a length is NaN.
double largest_error(const Strand& strand, Input x) {
  double largest = 0;
  for (int i = 0; i < strand.segments(); ++i) {
    const double l0 = strand.rest_length[i], error = std::abs(segment(x, i).norm() - l0) / l0;
    if (!(error <= largest)) largest = error;
    if (std::isnan(largest)) break;
  }
  return largest;
}

// The sum of the squared errors, which Newton's method must make smaller.
double squared_errors(const Strand& strand, Input x) {
  double sum = 0;
  for (int i = 0; i < strand.segments(); ++i) {
    const double l0 = strand.rest_length[i], error = (segment(x, i).norm() - l0) / l0;
    sum += error * error;
  }
  return sum;
}

// J W J^T for directions u, factored, and solves with it. With the inverse masses w, and the cosine c and the
// sine s of the angle of two neighbours, its diagonal is w_i + w_{i+1}, and the entry beside it -w_i c_i.
// Elimination from the root on leaves the diagonal w_{i+1} + q_i, with
//
//   q_0 = w_0 = 0,   q_i = w_i - (w_i c_i)^2 / (w_i + q_{i-1}) = w_i (q_{i-1} + w_i s_i^2) / (w_i + q_{i-1}):
//
// nothing is ever subtracted, so it is as accurate for a straight strand of 10,000 particles, whose condition
// number is 1e8, as for two.
class Multipliers {
 public:
  // Four columns of work.
  Multipliers(const Strand& strand, Scratch work) : strand_(strand), work_(work) {}

  void factor(Input x) {
    Vector3d before = strand_.root_tangent;
    double q = 0;
    for (int i = 0; i < strand_.segments(); ++i) {
      const Vector3d u = direction(segment(x, i), before);
      if (i > 0) {
        const double w = inverse_mass(strand_, i), pivot = w + q;
        work_(i, 1) = -w * before.dot(u) / pivot;  // the factor below the diagonal
        q = w * (q + w * before.cross(u).squaredNorm()) / pivot;
      }
      work_(i, 2) = inverse_mass(strand_, i + 1) + q;
      work_.col(0).segment<3>(3 * i) = u;
      before = u;
    }
  }

  Eigen::Ref<Eigen::VectorXd> rhs() { return work_.col(3).head(strand_.segments()); }

  Vector3d along(int i) const { return work_.col(0).segment<3>(3 * i); }

  // change = W J^T lambda, where J W J^T lambda = rhs.
  void solve(Output change) {
    auto lambda = rhs();
    const int n = strand_.segments();
    for (int i = 1; i < n; ++i) lambda[i] -= work_(i, 1) * lambda[i - 1];
    for (int i = 0; i < n; ++i) lambda[i] /= work_(i, 2);
    for (int i = n - 2; i >= 0; --i) lambda[i] -= work_(i + 1, 1) * lambda[i + 1];
    change.setZero();
    for (int i = 0; i < n; ++i) {
      change.segment<3>(3 * i) -= inverse_mass(strand_, i) * lambda[i] * along(i);
      change.segment<3>(3 * i + 3) += inverse_mass(strand_, i + 1) * lambda[i] * along(i);
    }
  }

 private:
  const Strand& strand_;
  Scratch work_;
};

// From the root on, places each particle at its distance from the one before, in its old direction: as a rope
// follows the hand that pulls it. All lengths are right at once, in any state, but it ignores masses.
void place(const Strand& strand, Output x) {
  Vector3d u = strand.root_tangent;
  for (int i = 0; i < strand.segments(); ++i) {  // from the root on
    u = direction(segment(x, i), u);
    x.segment<3>(3 * i + 3) = x.segment<3>(3 * i) + strand.rest_length[i] * u;
  }
}

// The smallest error that can be reached, since coordinates are rounded to doubles. Errors above it are
// errors, for any reason.
double rounding_error(const Strand& strand, Input x) {
  if (strand.segments() == 0) return 0;
  return std::min(0x1p-51 * x.cwiseAbs().maxCoeff() / strand.rest_length.minCoeff(), 1e-3);
}

// Newton's method ends in a few steps, or does not work, as with a root that was flung away, or masses that
// differ by 1e6. It then gives way to `place`.
constexpr int kMostNewtonSteps = 30;
constexpr double kSmallestPart = 0x1p-10;

}  // namespace

CorrectionReport relax_lengths(const Strand& strand, double tolerance, int most_sweeps, Output x) {
  CorrectionReport report;
  report.error = largest_error(strand, x);
  while (report.error > tolerance && report.iterations < most_sweeps) {
    ++report.iterations;
    Vector3d u = strand.root_tangent;
    for (int i = 0; i < strand.segments(); ++i) {
      const Vector3d e = segment(x, i);
      u = direction(e, u);
      const double w0 = inverse_mass(strand, i), w1 = inverse_mass(strand, i + 1);
      const Vector3d impulse = (e.norm() - strand.rest_length[i]) / (w0 + w1) * u;
      x.segment<3>(3 * i) += w0 * impulse;
      x.segment<3>(3 * i + 3) -= w1 * impulse;
    }
    report.error = largest_error(strand, x);
  }
  report.converged = report.error <= tolerance;
  return report;
}

CorrectionReport correct_lengths(const Strand& strand, double tolerance, int most_iterations, Output x,
                                 Scratch scratch) {
  Multipliers multipliers(strand, scratch.leftCols(4));
  // These are the last columns, so that a caller that keeps something there loses it.
  auto step = scratch.col(6), tried = scratch.col(7);
  const double goal = std::max(tolerance, rounding_error(strand, x));
  CorrectionReport report;
  report.error = largest_error(strand, x);
  while (report.error > goal && std::isfinite(report.error) && report.iterations < most_iterations) {
    ++report.iterations;
    multipliers.factor(x);
    auto minus_C = multipliers.rhs();
    for (int i = 0; i < strand.segments(); ++i) minus_C[i] = strand.rest_length[i] - segment(x, i).norm();
    multipliers.solve(step);

    // A full step may turn a segment so far that it gets longer; a part of the step does not.
    const double before = squared_errors(strand, x);
    double part = 1;
    do {
      tried = x + part * step;
    } while (!(squared_errors(strand, tried) < before) && (part /= 2) >= kSmallestPart);
    const bool newton = part >= kSmallestPart && report.iterations <= kMostNewtonSteps;
    if (newton)
      x = tried;
    else
      place(strand, x);
    report.error = largest_error(strand, x);
    if (!newton) break;
  }
  report.converged = report.error <= goal && std::isfinite(report.error);
  return report;
}

CorrectionReport correct_velocities(const Strand& strand, Input x, double tolerance, int most_sweeps,
                                    Output v, Scratch scratch) {
  Multipliers multipliers(strand, scratch.leftCols(4));
  auto change = scratch.col(7);
  multipliers.factor(x);
  CorrectionReport report;
  for (;;) {
    auto rates = multipliers.rhs();
    report.error = 0;
    for (int i = 0; i < strand.segments(); ++i) {
      rates[i] = -multipliers.along(i).dot(segment(v, i));
      // A NaN stays.
      if (!(std::abs(rates[i]) <= report.error) && !std::isnan(report.error))
        report.error = std::abs(rates[i]);
    }
    if (!(report.error > tolerance) || report.iterations == most_sweeps) break;
    ++report.iterations;
    multipliers.solve(change);
    v += change;
  }
  report.converged = report.error <= tolerance;
  return report;
}

}  // namespace hair
