// A root's frame: the point where a hair starts, and its direction there.
#pragma once

#include <Eigen/Core>

namespace hair {

using Eigen::Vector3d;

// axis and side have length 1 and are perpendicular.
struct RootFrame {
  Vector3d position = Vector3d::Zero();  // m
  Vector3d axis = Vector3d(0, 0, -1);
  Vector3d side = Vector3d(1, 0, 0);
};

}  // namespace hair
