// STAFF ONLY. X1 with vectors of its own.
#include "particles/air_drag.h"

#include <cmath>
#include <vector>

namespace {

struct Vec {
  double x, y, z;
};

Vec operator-(Vec a, Vec b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

std::vector<Vec> vectors(const double* numbers, long n) {
  std::vector<Vec> all;
  for (long i = 0; i < n; ++i) all.push_back({numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]});
  return all;
}

}  // namespace

namespace particles {

void add_air_drag(double coefficient, Input wind, Input v, Output f) {
  const std::vector<Vec> air = vectors(wind.data(), v.size() / 3), moving = vectors(v.data(), v.size() / 3);
  for (std::size_t i = moving.size(); i-- > 0;) {
    const Vec u = moving[i] - air[i];
    const double pull = -std::hypot(u.x, u.y, u.z) * coefficient;
    f[3 * i] += pull * u.x;
    f[3 * i + 1] += pull * u.y;
    f[3 * i + 2] += pull * u.z;
  }
}

}  // namespace particles
