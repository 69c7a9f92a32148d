// STAFF ONLY. A number for each pixel, and separable filters along rows and columns.
#pragma once

#include <cstddef>
#include <vector>

namespace grader::inline compare {

struct Plane {
  int width = 0, height = 0;
  std::vector<float> values;  // rows from the top down

  Plane() = default;
  Plane(int w, int h)
      : width(w), height(h), values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
  float* row(int y) { return values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width); }
  const float* row(int y) const {
    return values.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width);
  }
};

// This has an odd number of weights, from -r to r.
using Kernel = std::vector<float>;

// Returns exp(-i^2 / (2 sigma^2)) for i from -radius to radius, scaled to the sum 1. sigma in pixels, > 0.
Kernel gaussian(double sigma, int radius);

// Computes out(x, y) = sum over i and j of along_rows[i] along_columns[j] in(x + i, y + j). Beyond its border
// the plane repeats its border values.
Plane filtered(const Plane& in, const Kernel& along_rows, const Kernel& along_columns);

}  // namespace grader::compare
