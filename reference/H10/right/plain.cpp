// STAFF ONLY. H10 as the text has it: each formula as it stands there.
#include "hair/strand_synthesis.h"

#include <cmath>

namespace hair {
namespace {

// The columns are axis, side, axis x side.
Matrix3d matrix_of(const RootFrame& frame) {
  Matrix3d A;
  A.col(0) = frame.axis;
  A.col(1) = frame.side;
  A.col(2) = frame.axis.cross(frame.side);
  return A;
}

// Rodrigues' formula about the common perpendicular.
Matrix3d from_to(const Vector3d& a, const Vector3d& b) {
  const Vector3d v = a.cross(b);
  const double c = a.dot(b);
  if (c < -1 + 1e-12) {
    const Vector3d w = a.unitOrthogonal();
    return 2 * w * w.transpose() - Matrix3d::Identity();
  }
  Matrix3d cross;
  cross << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return Matrix3d::Identity() + cross + cross * cross / (1 + c);
}

std::array<double, 3> on_edges(const std::array<Vector3d, 3>& corners, const Vector3d& root) {
  std::array<double, 3> best{1, 0, 0};
  double nearest = (root - corners[0]).norm();
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const Vector3d edge = corners[j] - corners[i];
    if (edge.norm() == 0) continue;
    double t = (root - corners[i]).dot(edge) / edge.dot(edge);
    if (t < 0) t = 0;
    if (t > 1) t = 1;
    const double distance = (root - corners[i] - t * edge).norm();
    if (distance < nearest) {
      nearest = distance;
      best = {0, 0, 0};
      best[i] = 1 - t;
      best[j] = t;
    }
  }
  return best;
}

}  // namespace

std::array<double, 3> root_weights(const std::array<Vector3d, 3>& corners, const Vector3d& root) {
  const Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  const double longest =
      std::sqrt(std::max({(corners[1] - corners[0]).squaredNorm(), (corners[2] - corners[1]).squaredNorm(),
                          (corners[0] - corners[2]).squaredNorm()}));
  if (normal.norm() <= 1e-8 * longest * longest) return on_edges(corners, root);
  std::array<double, 3> weights;
  for (int i = 0; i < 3; ++i) {
    const Vector3d from = corners[(i + 1) % 3], to = corners[(i + 2) % 3];
    weights[i] = (to - from).cross(root - from).dot(normal) / normal.squaredNorm();
  }
  if (weights[0] < 0 || weights[1] < 0 || weights[2] < 0) return on_edges(corners, root);
  return weights;
}

void interpolate(const std::array<GuideHair, 3>& guides, const std::array<double, 3>& weights,
                 const RootFrame& root, Output child) {
  for (int i = 0; i < child.size() / 3; ++i) {
    Vector3d mean = Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      const Vector3d from_root = guides[k].points.segment<3>(3 * i) - guides[k].root.position;
      mean += weights[k] * matrix_of(guides[k].root).transpose() * from_root;
    }
    child.segment<3>(3 * i) = root.position + matrix_of(root) * mean;
  }
}

void carry_along(Input guide, GuideFrames& frames) {
  const int n = static_cast<int>(frames.turns.size());
  double length = 0;
  Vector3d before = Vector3d::Zero();
  frames.arc[0] = 0;
  frames.turns[0] = Matrix3d::Identity();
  for (int i = 1; i < n; ++i) {
    const Vector3d segment = guide.segment<3>(3 * i) - guide.segment<3>(3 * i - 3);
    length += segment.norm();
    frames.arc[i] = length;
    if (segment.norm() == 0) {
      frames.turns[i] = frames.turns[i - 1];
      continue;
    }
    const Vector3d now = segment.normalized();
    if (before.norm() == 0) before = now;  // the first
    frames.turns[i] = from_to(before, now) * frames.turns[i - 1];
    before = now;
  }
  if (length > 0)
    for (int i = 0; i < n; ++i) frames.arc[i] /= length;
}

void extrapolate(Input guide, const GuideFrames& frames, const Vector3d& root, double spread, Output child) {
  const Vector3d between = root - guide.head<3>();
  const int n = static_cast<int>(frames.turns.size());
  for (int i = 0; i < n; ++i) {
    const double growth = 1 + (spread - 1) * frames.arc[i];
    child.segment<3>(3 * i) = guide.segment<3>(3 * i) + growth * frames.turns[i] * between;
  }
}

void blend(Input arc, Input at_root, Input at_tip, Output child) {
  for (int i = 0; i < arc.size(); ++i) {
    const double w = arc[i] * arc[i] * (3 - 2 * arc[i]);
    child.segment<3>(3 * i) = (1 - w) * at_root.segment<3>(3 * i) + w * at_tip.segment<3>(3 * i);
  }
}

}  // namespace hair
