// STAFF ONLY. A right solution of H10 with matrices: a turn is two half turns, about the first direction and
// about the middle of both. The product of two frames carries a guide over. Weights come from the regions
// around a triangle, in long double.
#include "hair/strand_synthesis.h"

#include <algorithm>
#include <cmath>

namespace hair {
namespace {

using Real = long double;
using Long3 = Eigen::Matrix<Real, 3, 1>;

Matrix3d half_turn(const Vector3d& axis) {
  return 2 * axis * axis.transpose() - Matrix3d::Identity();
}

Matrix3d turn(const Vector3d& from, const Vector3d& to) {
  Vector3d middle = from + to;
  if (middle.norm() < 1e-9) middle = from.unitOrthogonal();
  return half_turn(middle.normalized()) * half_turn(from);
}

Matrix3d axes(const RootFrame& frame) {
  return (Matrix3d() << frame.axis, frame.side, frame.axis.cross(frame.side)).finished();
}

// The place of the point nearest to p on the edge from a to b, 0 to 1, and its squared distance.
Real place_on_edge(const Long3& a, const Long3& b, const Long3& p, Real& distance) {
  const Long3 edge = b - a;
  const Real square = edge.squaredNorm();
  const Real t = square > 0 ? std::clamp(edge.dot(p - a) / square, Real{0}, Real{1}) : Real{0};
  distance = (a + t * edge - p).squaredNorm();
  return t;
}

}  // namespace

std::array<double, 3> root_weights(const std::array<Vector3d, 3>& corners, const Vector3d& root) {
  const Long3 p = root.cast<Real>();
  std::array<Long3, 3> x;
  for (int k = 0; k < 3; ++k) x[k] = corners[k].cast<Real>();
  const Long3 a = x[1] - x[0], b = x[2] - x[0], N = a.cross(b);
  // Inside, the point is on the inner side of each edge.
  const Real area = N.squaredNorm(),
             size = std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
  if (area > 1e-20L * size * size) {
    const Real second = (p - x[0]).cross(b).dot(N) / area, third = a.cross(p - x[0]).dot(N) / area;
    if (second >= 0 && third >= 0 && second + third <= 1)
      return {static_cast<double>(1 - second - third), static_cast<double>(second),
              static_cast<double>(third)};
  }
  std::array<double, 3> weights{};
  Real nearest = -1;
  for (int k = 0; k < 3; ++k) {
    Real distance;
    const int next = (k + 1) % 3;
    const Real t = place_on_edge(x[k], x[next], p, distance);
    if (nearest >= 0 && distance >= nearest) continue;
    nearest = distance;
    weights = {};
    weights[k] = static_cast<double>(1 - t);
    weights[next] = static_cast<double>(t);
  }
  return weights;
}

void interpolate(const std::array<GuideHair, 3>& guides, const std::array<double, 3>& weights,
                 const RootFrame& root, Output child) {
  Eigen::Map<Eigen::Matrix3Xd> points(child.data(), 3, child.size() / 3);
  points.colwise() = root.position;
  for (int k = 0; k < 3; ++k) {
    const Matrix3d carry = weights[k] * axes(root) * axes(guides[k].root).transpose();
    const Eigen::Map<const Eigen::Matrix3Xd> guide(guides[k].points.data(), 3, points.cols());
    for (Eigen::Index i = 0; i < points.cols(); ++i)
      points.col(i) += carry * (guide.col(i) - guides[k].root.position);
  }
}

void carry_along(Input guide, GuideFrames& frames) {
  const Eigen::Map<const Eigen::Matrix3Xd> points(guide.data(), 3, guide.size() / 3);
  Vector3d direction = Vector3d::Zero();
  Real length = 0;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    frames.turns[i] = i == 0 ? Matrix3d(Matrix3d::Identity()) : frames.turns[i - 1];
    frames.arc[i] = static_cast<double>(length);
    if (i == 0) continue;
    const Vector3d step = points.col(i) - points.col(i - 1);
    if (step.isZero(0)) continue;
    const Vector3d next = step.normalized();
    if (!direction.isZero(0)) frames.turns[i] = turn(direction, next) * frames.turns[i];
    direction = next;
    length += step.norm();
    frames.arc[i] = static_cast<double>(length);
  }
  if (length > 0) frames.arc /= static_cast<double>(length);
}

void extrapolate(Input guide, const GuideFrames& frames, const Vector3d& root, double spread, Output child) {
  const Vector3d apart = root - guide.head<3>();
  child = guide;
  for (Eigen::Index i = 0; i < frames.arc.size(); ++i) {
    const Vector3d turned = frames.turns[i] * apart;
    child.segment<3>(3 * i) += turned + (spread - 1) * frames.arc[i] * turned;
  }
}

void blend(Input arc, Input at_root, Input at_tip, Output child) {
  for (Eigen::Index k = 0; k < child.size(); ++k) {
    const double s = arc[k / 3], w = 3 * s * s - 2 * s * s * s;
    child[k] = at_root[k] * (1 - w) + at_tip[k] * w;
  }
}

}  // namespace hair
