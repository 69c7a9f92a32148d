// STAFF ONLY. A right H5 by relaxation alone, from the tip to the root and back, without Newton's method.
#include "hair/length_correction.h"

#include <cmath>

namespace hair {
namespace {

// The larger value, or NaN if one is NaN.
double larger(double value, double other) {
  return other > value || std::isnan(other) ? other : value;
}

using Eigen::Vector3d;

// Moves the ends of segment i against each other by `change` along u, by their masses; the root stays.
void share(const Strand& strand, int i, const Vector3d& change, Output values) {
  if (i == 0) {
    values.segment<3>(3) -= change;
    return;
  }
  const double m0 = strand.mass[i], m1 = strand.mass[i + 1];
  values.segment<3>(3 * i) += m1 / (m0 + m1) * change;
  values.segment<3>(3 * i + 3) -= m0 / (m0 + m1) * change;
}

// The direction of segment i, or of the nearest one towards the root that has a direction.
Vector3d direction(const Strand& strand, Input x, int i) {
  for (; i >= 0; --i) {
    const Vector3d e = x.segment<3>(3 * i + 3) - x.segment<3>(3 * i);
    if (e.norm() > 0) return e / e.norm();
  }
  return strand.root_tangent;
}

double length(Input x, int i) {
  return (x.segment<3>(3 * i + 3) - x.segment<3>(3 * i)).norm();
}

double largest(const Strand& strand, Input x) {
  double value = 0;
  for (int i = strand.segments() - 1; i >= 0; --i)
    value = larger(value, std::fabs(length(x, i) / strand.rest_length[i] - 1));
  return value;
}

CorrectionReport relax(const Strand& strand, double tolerance, int most, Output x) {
  CorrectionReport report;
  for (;;) {
    report.error = largest(strand, x);
    report.converged = report.error <= tolerance;
    if (report.converged || report.iterations == most) return report;
    const auto place = [&](int i) {
      share(strand, i, (length(x, i) - strand.rest_length[i]) * direction(strand, x, i), x);
    };
    for (int i = strand.segments() - 1; i >= 0; --i) place(i);
    for (int i = 1; i < strand.segments(); ++i) place(i);
    ++report.iterations;
  }
}

}  // namespace

CorrectionReport relax_lengths(const Strand& strand, double tolerance, int most_sweeps, Output x) {
  return relax(strand, tolerance, most_sweeps, x);
}

CorrectionReport correct_lengths(const Strand& strand, double tolerance, int most_iterations, Output x,
                                 Scratch /*scratch*/) {
  return relax(strand, tolerance, most_iterations, x);
}

CorrectionReport correct_velocities(const Strand& strand, Input x, double tolerance, int most_sweeps,
                                    Output v, Scratch /*scratch*/) {
  CorrectionReport report;
  const auto rate = [&](int i) {
    return direction(strand, x, i).dot(v.segment<3>(3 * i + 3) - v.segment<3>(3 * i));
  };
  for (;;) {
    report.error = 0;
    for (int i = 0; i < strand.segments(); ++i) report.error = larger(report.error, std::fabs(rate(i)));
    report.converged = report.error <= tolerance;
    if (report.converged || report.iterations == most_sweeps) return report;
    for (int i = strand.segments() - 1; i >= 0; --i) share(strand, i, rate(i) * direction(strand, x, i), v);
    ++report.iterations;
  }
}

}  // namespace hair
