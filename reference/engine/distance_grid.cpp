// STAFF ONLY. Fills a solid's grid of distances, and looks them up.
#include "reference/engine/distance_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "particles/require.h"

namespace hair::engine {

namespace {

constexpr double kLargest = std::numeric_limits<std::int16_t>::max();

}  // namespace

DistanceGrid::DistanceGrid(const Solid& solid, double spacing) : box_(solid.box()), spacing_(spacing) {
  particles::require_positive("a grid's spacing", spacing);
  low_ = box_.min() - Vector3d::Constant(2 * spacing);
  const Vector3d counts = ((box_.sizes() / spacing).array() + 5).ceil();
  particles::require(counts.prod() <= kMostPoints, "the number of a grid's points", counts.prod(),
                     "at most 2e8: make the spacing larger");
  for (int axis = 0; axis < 3; ++axis) count_[axis] = static_cast<int>(counts[axis]);
  std::vector<float> distances;
  distances.reserve(static_cast<std::size_t>(counts.prod()));
  for (int k = 0; k < count_[2]; ++k)
    for (int j = 0; j < count_[1]; ++j)
      for (int i = 0; i < count_[0]; ++i)
        distances.push_back(
            static_cast<float>(solid.surface_at(low_ + spacing * Vector3d(i, j, k)).distance));

  double largest = 0;
  for (const float distance : distances) largest = std::max(largest, std::abs(double{distance}));
  unit_ = std::max(largest, spacing) / kLargest;
  distances_.reserve(distances.size());
  for (const float distance : distances)
    distances_.push_back(static_cast<std::int16_t>(std::lround(distance / unit_)));

  reaches_inside_.assign(distances_.size() / 32 + 1, 0);
  for (int k = 0; k + 1 < count_[2]; ++k)
    for (int j = 0; j + 1 < count_[1]; ++j)
      for (int i = 0; i + 1 < count_[0]; ++i) {
        const std::size_t cell = index(i, j, k);
        bool inside = false;
        for (int corner = 0; corner < 8; ++corner)
          inside |= distances_[index(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2))] < 0;
        if (inside) reaches_inside_[cell / 32] |= static_cast<std::int32_t>(1U << (cell % 32));
      }
}

GridView DistanceGrid::view() const {
  const auto last = [&](int axis) { return std::nextafter(static_cast<float>(count_[axis] - 1), 0.0F); };
  return {distances_.data(),
          unit_,
          reaches_inside_.data(),
          {low_.x(), low_.y(), low_.z()},
          1 / spacing_,
          {count_[0], count_[1], count_[2]},
          {last(0), last(1), last(2)}};
}

Surface DistanceGrid::surface_at(const Vector3d& point) const {
  const Vector3d cell = (1 / spacing_) * (point - low_);
  for (int axis = 0; axis < 3; ++axis)
    if (!(cell[axis] >= 0 && cell[axis] < count_[axis] - 1)) {
      const Vector3d out = point - point.cwiseMax(box_.min()).cwiseMin(box_.max());
      const double distance = out.norm();
      return {std::max(distance, spacing_), distance > 0 ? Vector3d(out / distance) : Vector3d::UnitZ()};
    }
  const Vector3d low = cell.array().floor(), t = cell - low;
  const Eigen::Vector3i at = low.cast<int>();
  double distance = 0;
  Vector3d gradient = Vector3d::Zero();
  for (int corner = 0; corner < 8; ++corner) {
    const int d[3] = {corner & 1, corner >> 1 & 1, corner >> 2};
    const double value = unit_ * distances_[index(at.x() + d[0], at.y() + d[1], at.z() + d[2])];
    Vector3d weight, slope;
    for (int axis = 0; axis < 3; ++axis) {
      weight[axis] = d[axis] ? t[axis] : 1 - t[axis];
      slope[axis] = d[axis] ? 1 : -1;
    }
    distance += value * weight.prod();
    gradient += value * Vector3d(slope.x() * weight.y() * weight.z(), weight.x() * slope.y() * weight.z(),
                                 weight.x() * weight.y() * slope.z());
  }
  const double length = gradient.norm(), slope = length / spacing_;
  return {distance / std::max(slope, kLeastSlope),
          length > 0 ? Vector3d(gradient / length) : Vector3d::UnitZ()};
}

}  // namespace hair::engine
