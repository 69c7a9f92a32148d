#include "hair/groom/nearest_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace hair {

NearestPoints::NearestPoints(std::vector<Eigen::Vector3d> points)
    : points_(std::move(points)), order_(points_.size()), axis_(points_.size()) {
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  build(0, points_.size());
}

void NearestPoints::build(std::size_t begin, std::size_t end) {
  if (begin == end) return;
  Eigen::Vector3d low = points_[order_[begin]], high = low;
  for (std::size_t i = begin; i < end; ++i) {
    low = low.cwiseMin(points_[order_[i]]);
    high = high.cwiseMax(points_[order_[i]]);
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end),
                   [&](std::size_t a, std::size_t b) { return points_[a][axis] < points_[b][axis]; });
  axis_[middle] = static_cast<unsigned char>(axis);
  build(begin, middle);
  build(middle + 1, end);
}

NearestPoints::Found NearestPoints::nearest(const Eigen::Vector3d& to, long except) const {
  Found best{-1, std::numeric_limits<double>::infinity()};
  search(0, points_.size(), to, except, best);
  return best.index < 0 ? Found{} : best;
}

void NearestPoints::search(std::size_t begin, std::size_t end, const Eigen::Vector3d& to, long except,
                           Found& best) const {
  if (begin == end) return;
  const std::size_t middle = begin + (end - begin) / 2;
  const Eigen::Vector3d& point = points_[order_[middle]];
  const double distance = (point - to).norm();
  if (const auto index = static_cast<long>(order_[middle]); index != except && distance < best.distance)
    best = {index, distance};
  const double across = to[axis_[middle]] - point[axis_[middle]];
  const bool left_first = across < 0;
  left_first ? search(begin, middle, to, except, best) : search(middle + 1, end, to, except, best);
  if (std::abs(across) < best.distance)
    left_first ? search(middle + 1, end, to, except, best) : search(begin, middle, to, except, best);
}

}  // namespace hair
