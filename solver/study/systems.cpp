#include "solver/study/systems.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace solver::study {

namespace {

System with_solution(std::string name, std::shared_ptr<implicitMatrix> matrix, int n, double smallest,
                     double largest) {
  System system = {std::move(name), std::move(matrix), largest, smallest, scattered(n, 3), {}};
  system.right_side = product(*system.matrix, system.solution);
  return system;
}

System spectral_system(std::string name, Vector spectrum) {
  const int n = static_cast<int>(spectrum.size());
  const auto [smallest, largest] = std::minmax_element(spectrum.begin(), spectrum.end());
  return with_solution(
      std::move(name),
      std::make_shared<SpectralMatrix>(spectrum, std::vector<Vector>{scattered(n, 1), scattered(n, 2)}), n,
      *smallest, *largest);
}

std::string short_text(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

}  // namespace

System spread_system(int n, double condition) {
  return spectral_system(short_text("condition %g", condition),
                         log_spaced(n, kLargestEigenvalue / condition, kLargestEigenvalue));
}

System clustered_system(int n, double condition, int clusters) {
  if (clusters < 2 || clusters > n)
    throw std::invalid_argument("clustered_system: " + std::to_string(clusters) + " clusters of " +
                                std::to_string(n) + " eigenvalues; need 2 to " + std::to_string(n));
  const Vector places = log_spaced(clusters, kLargestEigenvalue / condition, kLargestEigenvalue);
  Vector spectrum(n);
  for (int i = 0; i < n; ++i) spectrum[i] = places[static_cast<long>(i) * clusters / n];
  return spectral_system(std::to_string(clusters) + " clusters", spectrum);
}

StrandNumbers strand_numbers(int segments) {
  constexpr double kRadius = 50e-6, kDensity = 1300, kYoung = 3e9, kLength = 0.3;  // m, kg/m^3, Pa, m
  const double area = std::numbers::pi * kRadius * kRadius, segment = kLength / segments;
  return {kDensity * area * segment, kYoung * area / segment,
          kYoung * area * kRadius * kRadius / 4 / (segment * segment * segment)};
}

SparseMatrix strand_matrix(int segments, double step) {
  const StrandNumbers strand = strand_numbers(segments);
  return strand_implicit_euler(Vector(segments, strand.mass), strand.stretch, strand.bend, step);
}

System strand_system(int segments, double step) {
  const StrandNumbers strand = strand_numbers(segments);
  // A chain of equal masses, held at one end: the springs' part of an eigenvalue is 4 k sin^2 of these
  // angles.
  const auto eigenvalue = [&](double k, int j) {
    const double sine = std::sin((2 * j - 1) * std::numbers::pi / (2 * (2 * segments + 1)));
    return strand.mass + 4 * step * step * k * sine * sine;
  };
  return with_solution(short_text("strand, h = %g ms", 1000 * step),
                       std::make_shared<SparseMatrix>(strand_matrix(segments, step)), 3 * segments,
                       eigenvalue(std::min(strand.stretch, strand.bend), 1),
                       eigenvalue(std::max(strand.stretch, strand.bend), segments));
}

Vector scattered(int n, unsigned seed) {
  Vector values(n);
  for (double& value : values) {
    seed = 1664525 * seed + 1013904223;  // Numerical Recipes' generator
    value = seed / 2147483648.0 - 1;
  }
  return values;
}

double squared_norm(const Vector& x) {
  return std::inner_product(x.begin(), x.end(), x.begin(), 0.0);
}

double energy_norm(implicitMatrix& A, Vector x) {
  const Vector Ax = product(A, x);
  return std::sqrt(std::inner_product(x.begin(), x.end(), Ax.begin(), 0.0));
}

Vector difference(const Vector& a, const Vector& b) {
  Vector result(a.size());
  std::transform(a.begin(), a.end(), b.begin(), result.begin(), std::minus<>());
  return result;
}

Vector product(implicitMatrix& A, Vector x) {
  Vector result(x.size());
  A.matVecMult(x.data(), result.data());
  return result;
}

}  // namespace solver::study
