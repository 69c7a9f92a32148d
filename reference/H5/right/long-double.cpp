// STAFF ONLY. A right H5 in long double, whose multipliers are eliminated from the tip to the root; velocities are corrected by
// the same system, all at once. Its sweeps take even segments before odd ones.
#include "hair/length_correction.h"

#include <cmath>
#include <vector>

namespace hair {
namespace {

using Real = long double;
using Row = std::vector<Real>;
using Long3 = Eigen::Matrix<Real, 3, 1>;

Long3 segment(Input x, int i) {
  return x.segment<3>(3 * i + 3).cast<Real>() - x.segment<3>(3 * i).cast<Real>();
}

Real inverse_mass(const Strand& strand, int i) {
  return i == 0 ? 0 : 1 / Real{strand.mass[i]};
}

// Of the nearest segment from i towards the root that has one.
Long3 direction(const Strand& strand, Input x, int i) {
  const Long3 e = segment(x, i);
  if (e.norm() > 0) return e.normalized();
  return i > 0 ? direction(strand, x, i - 1) : Long3(strand.root_tangent.cast<Real>());
}

std::vector<Long3> directions(const Strand& strand, Input x) {
  std::vector<Long3> u;
  for (int i = 0; i < strand.segments(); ++i) u.push_back(direction(strand, x, i));
  return u;
}

// Moves the ends of segment i apart by `lambda` times their inverse masses.
void push(const Strand& strand, int i, const Long3& lambda, Output values) {
  values.segment<3>(3 * i) -= (inverse_mass(strand, i) * lambda).cast<double>();
  values.segment<3>(3 * i + 3) += (inverse_mass(strand, i + 1) * lambda).cast<double>();
}

// values += W J^T lambda, where J W J^T lambda = right.
void add_correction(const Strand& strand, const std::vector<Long3>& u, Row right, Output values) {
  const int rows = strand.segments();
  Row pivot(rows), beside(rows);  // beside[i]: of rows i and i + 1
  for (int i = rows - 1; i >= 0; --i) {
    pivot[i] = inverse_mass(strand, i) + inverse_mass(strand, i + 1);
    if (i == rows - 1) continue;
    beside[i] = -inverse_mass(strand, i + 1) * u[i].dot(u[i + 1]);
    pivot[i] -= beside[i] * beside[i] / pivot[i + 1];
    right[i] -= beside[i] * right[i + 1] / pivot[i + 1];
  }
  for (int i = 0; i < rows; ++i) {
    if (i > 0) right[i] -= beside[i - 1] * right[i - 1];
    right[i] /= pivot[i];
    push(strand, i, right[i] * u[i], values);
  }
}

// The largest size, or a NaN, if there is one.
double largest(const Row& values) {
  Real found = 0;
  for (const Real value : values)
    if (!(std::fabs(value) <= found)) found = std::fabs(value);
  for (const Real value : values)
    if (std::isnan(value)) found = value;
  return static_cast<double>(found);
}

Row missing(const Strand& strand, Input x) {
  Row values;
  for (int i = 0; i < strand.segments(); ++i) values.push_back(strand.rest_length[i] - segment(x, i).norm());
  return values;
}

double length_error(const Strand& strand, Input x) {
  Row values = missing(strand, x);
  for (int i = 0; i < strand.segments(); ++i) values[i] /= strand.rest_length[i];
  return largest(values);
}

// correct(), until error() is small enough.
template <typename Error, typename Correct>
CorrectionReport repeat(double tolerance, int most, const Error& error, const Correct& correct) {
  CorrectionReport report;
  while ((report.error = error()) > tolerance && report.iterations < most) {
    correct();
    ++report.iterations;
  }
  report.converged = report.error <= tolerance;
  return report;
}

}  // namespace

CorrectionReport relax_lengths(const Strand& strand, double tolerance, int most_sweeps, Output x) {
  const auto sweep = [&] {
    for (int first = 0; first < 2; ++first)
      for (int i = first; i < strand.segments(); i += 2) {
        const Real weights = inverse_mass(strand, i) + inverse_mass(strand, i + 1);
        const Real lambda = (strand.rest_length[i] - segment(x, i).norm()) / weights;
        push(strand, i, lambda * direction(strand, x, i), x);
      }
  };
  return repeat(
      tolerance, most_sweeps, [&] { return length_error(strand, x); }, sweep);
}

CorrectionReport correct_lengths(const Strand& strand, double tolerance, int most_iterations, Output x,
                                 Scratch /*scratch*/) {
  return repeat(
      tolerance, most_iterations, [&] { return length_error(strand, x); },
      [&] { add_correction(strand, directions(strand, x), missing(strand, x), x); });
}

CorrectionReport correct_velocities(const Strand& strand, Input x, double tolerance, int most_sweeps,
                                    Output v, Scratch /*scratch*/) {
  const std::vector<Long3> u = directions(strand, x);
  Row rates(u.size());
  const auto error = [&] {
    for (int i = 0; i < strand.segments(); ++i) rates[i] = -u[i].dot(segment(v, i));
    return largest(rates);
  };
  return repeat(tolerance, most_sweeps, error, [&] { add_correction(strand, u, rates, v); });
}

}  // namespace hair
