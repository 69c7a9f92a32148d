// STAFF ONLY. A right H5, straight from the formulas. The patches for H5 apply to it.
#include "hair/length_correction.h"

#include <cmath>
#include <vector>

namespace hair {

using Eigen::Vector3d;
using std::vector;

static double weight(const Strand& strand, int i) {
  if (i == 0) return 0;  // the root
  return 1 / strand.mass[i];
}

static Vector3d between(Input x, int i) {
  return x.segment<3>(3 * (i + 1)) - x.segment<3>(3 * i);
}

static vector<Vector3d> directions(const Strand& strand, Input x) {
  vector<Vector3d> u(strand.segments());
  for (int i = 0; i < strand.segments(); ++i) {
    const Vector3d e = between(x, i);
    if (e.norm() > 0)
      u[i] = e / e.norm();
    else
      u[i] = i == 0 ? strand.root_tangent : u[i - 1];
  }
  return u;
}

// The larger value, or NaN if one is NaN.
static double larger(double a, double b) {
  return b > a || std::isnan(b) ? b : a;
}

static double worst_length(const Strand& strand, Input x) {
  double worst = 0;
  for (int i = 0; i < strand.segments(); ++i) {
    const double error = std::abs(between(x, i).norm() - strand.rest_length[i]) / strand.rest_length[i];
    if (error > worst || std::isnan(error)) worst = error;
  }
  return worst;
}

CorrectionReport relax_lengths(const Strand& strand, double tolerance, int most_sweeps, Output x) {
  CorrectionReport report;
  report.error = worst_length(strand, x);
  while (report.error > tolerance && report.iterations < most_sweeps) {
    Vector3d u = strand.root_tangent;
    for (int i = 0; i < strand.segments(); ++i) {
      const Vector3d e = between(x, i);
      const double length = e.norm();
      if (length > 0) u = e / length;
      const double w0 = weight(strand, i), w1 = weight(strand, i + 1);
      const double too_long = length - strand.rest_length[i];
      x.segment<3>(3 * i) += w0 / (w0 + w1) * too_long * u;
      x.segment<3>(3 * i + 3) -= w1 / (w0 + w1) * too_long * u;
    }
    ++report.iterations;
    report.error = worst_length(strand, x);
  }
  report.converged = report.error <= tolerance;
  return report;
}

// Solves J W J' lambda = rhs (Thomas's algorithm), and returns W J' lambda as a vector per particle.
static vector<Vector3d> impulses(const Strand& strand, const vector<Vector3d>& u, vector<double> rhs) {
  const int m = strand.segments();
  vector<double> diagonal(m), beside(m);  // beside[i] belongs to i and i - 1
  for (int i = 0; i < m; ++i) {
    diagonal[i] = weight(strand, i) + weight(strand, i + 1);
    if (i > 0) beside[i] = -weight(strand, i) * u[i - 1].dot(u[i]);
  }
  for (int i = 1; i < m; ++i) {
    const double factor = beside[i] / diagonal[i - 1];
    diagonal[i] -= factor * beside[i];
    rhs[i] -= factor * rhs[i - 1];
  }
  vector<double> lambda(m);
  for (int i = m - 1; i >= 0; --i) {
    lambda[i] = rhs[i];
    if (i + 1 < m) lambda[i] -= beside[i + 1] * lambda[i + 1];
    lambda[i] /= diagonal[i];
  }
  vector<Vector3d> moves(strand.count(), Vector3d::Zero());
  for (int i = 0; i < m; ++i) {
    moves[i] -= weight(strand, i) * lambda[i] * u[i];
    moves[i + 1] += weight(strand, i + 1) * lambda[i] * u[i];
  }
  return moves;
}

CorrectionReport correct_lengths(const Strand& strand, double tolerance, int most_iterations, Output x,
                                 Scratch /*scratch*/) {
  CorrectionReport report;
  report.error = worst_length(strand, x);
  while (report.error > tolerance && report.iterations < most_iterations) {
    vector<double> missing(strand.segments());
    for (int i = 0; i < strand.segments(); ++i) missing[i] = strand.rest_length[i] - between(x, i).norm();
    const vector<Vector3d> moves = impulses(strand, directions(strand, x), missing);
    for (int i = 0; i < strand.count(); ++i) x.segment<3>(3 * i) += moves[i];
    ++report.iterations;
    report.error = worst_length(strand, x);
  }
  report.converged = report.error <= tolerance;
  return report;
}

CorrectionReport correct_velocities(const Strand& strand, Input x, double tolerance, int most_sweeps,
                                    Output v, Scratch /*scratch*/) {
  const vector<Vector3d> u = directions(strand, x);
  CorrectionReport report;
  while (true) {
    report.error = 0;
    for (int i = 0; i < strand.segments(); ++i)
      report.error = larger(report.error, std::abs(u[i].dot(between(v, i))));
    report.converged = report.error <= tolerance;
    if (report.converged || report.iterations >= most_sweeps) return report;

    for (int i = 0; i < strand.segments(); ++i) {
      const double w0 = weight(strand, i), w1 = weight(strand, i + 1);
      const double impulse = u[i].dot(between(v, i)) / (w0 + w1);
      v.segment<3>(3 * i) += w0 * impulse * u[i];
      v.segment<3>(3 * i + 3) -= w1 * impulse * u[i];
    }
    ++report.iterations;
  }
}

}  // namespace hair
