// STAFF ONLY. A right H5 with vectors of its own. It eliminates and sweeps from the tip to the root, and
// solves for all impulses on velocities at once.
#include "hair/length_correction.h"

#include <array>
#include <cmath>
#include <vector>

namespace {

using Point = std::array<double, 3>;
using hair::Strand, hair::Input, hair::Output, hair::CorrectionReport;

Point minus(Input x, int to, int from) {
  return {x[3 * to] - x[3 * from], x[3 * to + 1] - x[3 * from + 1], x[3 * to + 2] - x[3 * from + 2]};
}
double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
double length(const Point& a) {
  return std::hypot(a[0], a[1], a[2]);
}

std::vector<Point> along(const Strand& strand, Input x) {
  std::vector<Point> u(static_cast<std::size_t>(strand.segments()));
  Point last = {strand.root_tangent[0], strand.root_tangent[1], strand.root_tangent[2]};
  for (std::size_t i = 0; i < u.size(); ++i) {
    const Point e = minus(x, static_cast<int>(i) + 1, static_cast<int>(i));
    if (const double l = length(e); l != 0) last = {e[0] / l, e[1] / l, e[2] / l};
    u[i] = last;
  }
  return u;
}

double inverse(const Strand& strand, std::size_t i) {
  return i > 0 ? 1 / strand.mass[static_cast<Eigen::Index>(i)] : 0;
}

// Adds impulses along u to y, so that the differences of neighbours along u change by `wanted`.
void push(const Strand& strand, const std::vector<Point>& u, std::vector<double> wanted, Output y) {
  const std::size_t m = u.size();
  std::vector<double> pivot(m), beside(m);
  for (std::size_t i = m; i-- > 0;) {
    pivot[i] = inverse(strand, i) + inverse(strand, i + 1);
    if (i + 1 == m) continue;
    beside[i] = -inverse(strand, i + 1) * dot(u[i], u[i + 1]) / pivot[i + 1];
    pivot[i] -= beside[i] * beside[i] * pivot[i + 1];
    wanted[i] -= beside[i] * wanted[i + 1];
  }
  double before = 0;
  for (std::size_t i = 0; i < m; ++i) {
    const double impulse = wanted[i] / pivot[i] - (i > 0 ? beside[i - 1] * before : 0);
    for (std::size_t k = 0; k < 3; ++k) {
      y[static_cast<Eigen::Index>(3 * i + k)] -= inverse(strand, i) * impulse * u[i][k];
      y[static_cast<Eigen::Index>(3 * i + 3 + k)] += inverse(strand, i + 1) * impulse * u[i][k];
    }
    before = impulse;
  }
}

// A NaN stays the largest.
double largest(const std::vector<double>& errors) {
  double most = 0;
  for (double error : errors)
    if (!(std::abs(error) <= most) && most == most) most = std::abs(error);
  return most;
}

std::vector<double> missing(const Strand& strand, Input x, bool relative) {
  std::vector<double> all;
  for (int i = 0; i < strand.segments(); ++i) {
    const double rest = strand.rest_length[i];
    all.push_back((rest - length(minus(x, i + 1, i))) / (relative ? rest : 1));
  }
  return all;
}

template <class Change>
CorrectionReport correct(const Strand& strand, double tolerance, int most, Output x, const Change& change) {
  CorrectionReport report;
  while (true) {
    report.error = largest(missing(strand, x, true));
    report.converged = report.error <= tolerance;
    if (!(report.error > tolerance) || report.iterations >= most) return report;
    change();
    ++report.iterations;
  }
}

}  // namespace

CorrectionReport hair::relax_lengths(const Strand& strand, double tolerance, int most_sweeps, Output x) {
  return correct(strand, tolerance, most_sweeps, x, [&] {
    const std::vector<Point> u = along(strand, x);
    for (int i = strand.segments() - 1; i >= 0; --i) {
      const auto k = static_cast<std::size_t>(i);
      const Point e = minus(x, i + 1, i);
      const double l = length(e), near = inverse(strand, k), far = inverse(strand, k + 1);
      for (std::size_t c = 0; c < 3; ++c) {
        const double direction = l != 0 ? e[c] / l : u[k][c];
        const double part = (l - strand.rest_length[i]) / (near + far) * direction;
        const auto place = static_cast<Eigen::Index>(3 * k + c);
        x[place] += near * part;
        x[place + 3] -= far * part;
      }
    }
  });
}

CorrectionReport hair::correct_lengths(const Strand& strand, double tolerance, int most_iterations, Output x,
                                       Scratch /*scratch*/) {
  return correct(strand, tolerance, most_iterations, x,
                 [&] { push(strand, along(strand, x), missing(strand, x, false), x); });
}

CorrectionReport hair::correct_velocities(const Strand& strand, Input x, double tolerance, int most_sweeps,
                                          Output v, Scratch /*scratch*/) {
  const std::vector<Point> u = along(strand, x);
  CorrectionReport report;
  while (true) {
    std::vector<double> rates;
    for (std::size_t i = 0; i < u.size(); ++i)
      rates.push_back(-dot(u[i], minus(v, static_cast<int>(i) + 1, static_cast<int>(i))));
    report.error = largest(rates);
    report.converged = report.error <= tolerance;
    if (!(report.error > tolerance) || report.iterations >= most_sweeps) return report;
    push(strand, u, rates, v);
    ++report.iterations;
  }
}
