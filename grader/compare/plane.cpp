// STAFF ONLY. Filters planes with separable kernels.
#include "grader/compare/plane.h"

#include <algorithm>
#include <cmath>

namespace grader::inline compare {
namespace {

// Computes out[x] += weight * in[x], the inner loop of all filters, which compilers vectorise.
void add_scaled(float weight, const float* in, float* out, int count) {
  for (int x = 0; x < count; ++x) out[x] += weight * in[x];
}

}  // namespace

Kernel gaussian(double sigma, int radius) {
  std::vector<double> weights;
  double sum = 0;
  for (int i = -radius; i <= radius; ++i) {
    weights.push_back(std::exp(-0.5 * i * i / (sigma * sigma)));
    sum += weights.back();
  }
  Kernel kernel;
  for (const double weight : weights) kernel.push_back(static_cast<float>(weight / sum));
  return kernel;
}

Plane filtered(const Plane& in, const Kernel& along_rows, const Kernel& along_columns) {
  const int width = in.width, height = in.height;
  if (in.values.empty()) return in;
  const int side = static_cast<int>(along_rows.size() / 2), up = static_cast<int>(along_columns.size() / 2);
  Plane across(width, height);
  std::vector<float> wide(static_cast<std::size_t>(width) + along_rows.size() - 1);
  for (int y = 0; y < height; ++y) {
    const float* row = in.row(y);
    std::fill_n(wide.begin(), side, row[0]);
    std::copy_n(row, width, wide.begin() + side);
    std::fill_n(wide.end() - side, side, row[width - 1]);
    for (std::size_t i = 0; i < along_rows.size(); ++i)
      add_scaled(along_rows[i], wide.data() + i, across.row(y), width);
  }
  Plane out(width, height);
  for (int y = 0; y < height; ++y)
    for (int j = 0; j < static_cast<int>(along_columns.size()); ++j)
      add_scaled(along_columns[static_cast<std::size_t>(j)],
                 across.row(std::clamp(y + j - up, 0, height - 1)), out.row(y), width);
  return out;
}

}  // namespace grader::compare
