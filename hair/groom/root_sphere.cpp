#include "hair/groom/root_sphere.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace hair {

namespace {

constexpr double kThinnest = 0.01;   // over the width: the thickness of points that are on no plane
constexpr double kNarrowest = 1e-6;  // over the width, for points that are on no line

// The extent of points: their middle, and the standard deviations along three axes, the smallest first.
struct Extent {
  Vector3d middle = Vector3d::Zero(), sizes;
  Eigen::Matrix3d axes;
};

Extent extent_of(const std::vector<Vector3d>& points) {
  Extent extent;
  const auto count = static_cast<double>(points.size());
  for (const Vector3d& point : points) extent.middle += point / count;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vector3d& point : points)
    spread += (point - extent.middle) * (point - extent.middle).transpose() / count;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  extent.sizes = solver.eigenvalues().cwiseMax(0).cwiseSqrt();
  extent.axes = solver.eigenvectors();
  return extent;
}

std::optional<RootSphere> sphere_through(const std::vector<Vector3d>& points, const Extent& extent) {
  if (points.size() < 4 || !(extent.sizes[0] > kThinnest * extent.sizes[2])) return {};
  // Coordinates are relative to the middle, in units of the width, so that all sums have similar sizes.
  const double unit = extent.sizes[2];
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (const Vector3d& point : points) {
    const Vector3d x = (point - extent.middle) / unit;
    const Eigen::Vector4d row(2 * x.x(), 2 * x.y(), 2 * x.z(), 1);
    matrix += row * row.transpose();
    right += x.squaredNorm() * row;
  }
  const Eigen::Vector4d found = matrix.ldlt().solve(right);
  const Vector3d centre = found.head<3>();
  return RootSphere{extent.middle + unit * centre, unit * std::sqrt(found[3] + centre.squaredNorm())};
}

}  // namespace

std::optional<RootSphere> sphere_through(const std::vector<Vector3d>& points) {
  return points.empty() ? std::nullopt : sphere_through(points, extent_of(points));
}

std::vector<RootFrame> scalp_of_roots(std::vector<RootFrame> roots) {
  if (roots.empty()) return roots;
  std::vector<Vector3d> points;
  Vector3d way = Vector3d::Zero();
  for (const RootFrame& root : roots) {
    points.push_back(root.position);
    way += root.axis;
  }
  const Extent extent = extent_of(points);
  if (!(extent.sizes[1] > kNarrowest * extent.sizes[2])) return roots;
  const std::optional<RootSphere> sphere = sphere_through(points, extent);
  const Vector3d across = extent.axes.col(0), plane = across.dot(way) < 0 ? Vector3d(-across) : across;
  for (RootFrame& root : roots) {
    const Vector3d out = sphere ? Vector3d(root.position - sphere->centre) : plane;
    if (out.norm() > 0) root.axis = out.normalized();
    root.side = side_of(root.axis);
  }
  return roots;
}

}  // namespace hair
