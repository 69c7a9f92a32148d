// STAFF ONLY. H10: strand synthesis.

#include "hair/strand_synthesis.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hair {
namespace {

// A triangle thinner than this part of its longest edge counts as its edges.
constexpr double kThin = 1e-9;

Matrix3d axes_of(const RootFrame& frame) {
  Matrix3d axes;
  axes << frame.axis, frame.side, frame.axis.cross(frame.side);
  return axes;
}

// The least rotation that turns a into b, both of length 1. It is two reflections: the first maps a to -a,
// the second -a to b. Each reverses the part along its normal.
Matrix3d least_rotation(const Vector3d& a, const Vector3d& b) {
  Vector3d normal = a + b;
  // If they are nearly opposite, a + b is only rounding: then any normal across them is as good, to 1e-8.
  if (normal.squaredNorm() < 1e-16) normal = a.unitOrthogonal();
  normal.normalize();
  Matrix3d rotation = Matrix3d::Identity() - 2 * a * a.transpose();
  rotation -= 2 * normal * (normal.transpose() * rotation).eval();
  return rotation;
}

}  // namespace

std::array<double, 3> root_weights(const std::array<Vector3d, 3>& corners, const Vector3d& root) {
  const Vector3d b = corners[1] - corners[0], c = corners[2] - corners[0], p = root - corners[0];
  const double longest = std::max({b.norm(), c.norm(), (c - b).norm()});
  const Vector3d area = b.cross(c);
  if (area.norm() > kThin * longest * longest) {
    const double of_b = area.dot(p.cross(c)) / area.squaredNorm(),
                 of_c = area.dot(b.cross(p)) / area.squaredNorm(), of_a = 1 - of_b - of_c;
    if (of_a >= 0 && of_b >= 0 && of_c >= 0) return {of_a, of_b, of_c};
  }
  // Outside the triangle the nearest point lies on an edge.
  std::array<double, 3> weights{1, 0, 0};
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    const Vector3d edge = corners[next] - corners[k], from = root - corners[k];
    const double size = edge.squaredNorm();
    const double part = size > 0 ? std::clamp(from.dot(edge) / size, 0.0, 1.0) : 0;
    const double distance = (from - part * edge).norm();
    if (distance < least) {
      least = distance;
      weights = {};
      weights[k] = 1 - part;
      weights[next] = part;
    }
  }
  return weights;
}

void interpolate(const std::array<GuideHair, 3>& guides, const std::array<double, 3>& weights,
                 const RootFrame& root, Output child) {
  const Matrix3d axes = axes_of(root);
  std::array<Matrix3d, 3> into;
  for (int k = 0; k < 3; ++k) into[k] = weights[k] * axes * axes_of(guides[k].root).transpose();
  for (Eigen::Index at = 0; at < child.size(); at += 3) {
    Vector3d point = root.position;
    for (int k = 0; k < 3; ++k)
      point += into[k] * (guides[k].points.segment<3>(at) - guides[k].root.position);
    child.segment<3>(at) = point;
  }
}

void carry_along(Input guide, GuideFrames& frames) {
  Vector3d direction = Vector3d::Zero();  // none yet
  double length = 0;
  frames.arc[0] = 0;
  frames.turns[0].setIdentity();
  for (std::size_t i = 1; i < frames.turns.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(3 * i);
    const Vector3d segment = guide.segment<3>(at) - guide.segment<3>(at - 3);
    const double size = segment.norm();
    frames.turns[i] = frames.turns[i - 1];
    if (size > 0) {
      const Vector3d next = segment / size;
      if (length > 0) frames.turns[i] = least_rotation(direction, next) * frames.turns[i - 1];
      direction = next;
    }
    length += size;
    frames.arc[static_cast<Eigen::Index>(i)] = length;
  }
  if (length > 0) frames.arc /= length;
}

void extrapolate(Input guide, const GuideFrames& frames, const Vector3d& root, double spread, Output child) {
  const Vector3d between = root - guide.head<3>();
  for (std::size_t i = 0; i < frames.turns.size(); ++i) {
    const auto index = static_cast<Eigen::Index>(i);
    const Vector3d grown = (1 + (spread - 1) * frames.arc[index]) * between;
    child.segment<3>(3 * index) = guide.segment<3>(3 * index) + frames.turns[i] * grown;
  }
}

void blend(Input arc, Input at_root, Input at_tip, Output child) {
  for (Eigen::Index i = 0; i < arc.size(); ++i) {
    const double weight = arc[i] * arc[i] * (3 - 2 * arc[i]);
    child.segment<3>(3 * i) = (1 - weight) * at_root.segment<3>(3 * i) + weight * at_tip.segment<3>(3 * i);
  }
}

}  // namespace hair
