// A box that holds a strand, in its root's frame: along axis, side and axis x side, with the root at 0.
#pragma once

#include "hair/strand/rest_shape.h"

namespace hair {

struct RootBox {
  Vector3d middle, half;  // m

  // The largest possible distance from the root.
  double farthest() const { return middle.norm() + half.norm(); }

  // Its extent along `direction`, in the root's frame.
  double reach(const Vector3d& direction) const {
    return direction.dot(middle) + direction.cwiseAbs().dot(half);
  }
};

inline Eigen::Matrix3d axes_of_root(const RootFrame& frame) {
  return (Eigen::Matrix3d() << frame.axis, frame.side, frame.axis.cross(frame.side)).finished();
}

// points: 3n numbers, in the world's axes.
inline RootBox box_of_strand(const RootFrame& root, particles::Input points) {
  const Eigen::Matrix3d seen = axes_of_root(root).transpose();
  Vector3d low = Vector3d::Zero(), high = low;
  for (Eigen::Index i = 3; i < points.size(); i += 3) {
    const Vector3d point = seen * (points.segment<3>(i) - root.position);
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return {(low + high) / 2, (high - low) / 2};
}

}  // namespace hair
