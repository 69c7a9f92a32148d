// Curves through a strand's points. Source: E. Catmull and R. Rom, "A Class of Local Interpolating Splines",
// Computer Aided Geometric Design, 1974: uniform, each segment a cubic whose ends have the slopes of their
// neighbours' chord.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <span>

namespace hair {

// The part of the curve between two points: at(0) is the first, at(1) the second.
struct CurveSegment {
  Eigen::Vector3f a, c1, c2, c3;

  Eigen::Vector3f at(float u) const { return a + u * (c1 + u * (c2 + u * c3)); }
  Eigen::Vector3f slope(float u) const { return c1 + u * (2 * c2 + u * 3 * c3); }
};

// Segment i of a strand's points; with a single point, that point. The curve continues straight beyond both
// ends.
inline CurveSegment curve_segment(std::span<const Eigen::Vector3f> at, int i) {
  const int size = static_cast<int>(at.size());
  const Eigen::Vector3f &a = at[i], &b = at[std::min(i + 1, size - 1)];
  const Eigen::Vector3f before = i > 0 ? at[i - 1] : Eigen::Vector3f(2 * a - b);
  const Eigen::Vector3f after = i + 2 < size ? at[i + 2] : Eigen::Vector3f(2 * b - a);
  return {a, (b - before) / 2, before - 2.5F * a + 2 * b - after / 2, 1.5F * (a - b) + (after - before) / 2};
}

}  // namespace hair
