// STAFF ONLY. A solid's distances on a grid, in integers of 16 bits, scaled to the largest distance. It is a
// solid itself: its distance between the grid's points is interpolated (trilinear), and its normal is the
// gradient of that. A bust's distances are right to 5e-6 m, a tenth of a hair's radius.
#pragma once

#include <array>
#include <vector>

#include "hair/obstacles/solid.h"
#include "reference/engine/group.h"

namespace hair::engine {

class DistanceGrid : public Solid {
 public:
  // The points are `spacing` metres apart and reach two spacings beyond the solid's box. Throws
  // std::invalid_argument for more than kMostPoints.
  DistanceGrid(const Solid& solid, double spacing);

  static constexpr double kMostPoints = 2e8;

  // Beyond the grid it returns the distance from the solid's box, at least one spacing, and the way from it.
  Surface surface_at(const Vector3d& point) const override;
  Eigen::AlignedBox3d box() const override { return box_; }

  GridView view() const;
  std::size_t bytes() const { return distances_.size() * sizeof(std::int16_t) + distances_.size() / 8; }

 private:
  std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * count_[1] + j) * count_[0] + i;
  }

  Eigen::AlignedBox3d box_;
  double spacing_;
  Vector3d low_;
  std::array<int, 3> count_;
  double unit_;  // m
  std::vector<std::int16_t> distances_;
  std::vector<std::int32_t> reaches_inside_;
};

}  // namespace hair::engine
