#include "hair/dense/scalp_map.h"

#include <limits>

namespace hair {

ScalpMap::ScalpMap(const std::vector<RootFrame>& roots) {
  Vector3d normal = Vector3d::Zero(), middle = Vector3d::Zero();
  for (const RootFrame& root : roots) {
    normal += root.axis;
    middle += root.position;
  }
  middle /= static_cast<double>(roots.size());
  // Normals that agree up to rounding count as equal.
  constexpr double kAlike = 1e-9;
  double best = -std::numeric_limits<double>::infinity(), distance = 0;
  for (const RootFrame& root : roots) {
    const double agrees = root.axis.dot(normal), far = (root.position - middle).squaredNorm();
    const double gain = agrees - best, alike = kAlike * static_cast<double>(roots.size());
    if (gain > alike || (gain > -alike && far < distance)) {
      best = agrees;
      distance = far;
      apex_ = root.position;
      pole_ = root.axis;
    }
  }
  x_ = side_of(pole_);
  y_ = pole_.cross(x_);
}

Eigen::Vector2d ScalpMap::at(const Vector3d& root) const {
  const Vector3d from = root - apex_;
  const Eigen::Vector2d along(from.dot(x_), from.dot(y_));
  const double size = along.norm();
  return size > 0 ? Eigen::Vector2d(from.norm() / size * along) : along;
}

}  // namespace hair
