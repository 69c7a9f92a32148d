#include "hair/render/camera.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hair/render/view.h"
#include "particles/require.h"

namespace hair {

namespace {

// A box smaller than the first size counts as one of the second size.
constexpr double kNoSize = 1e-9, kSmallest = 1e-3;  // m

}  // namespace

std::array<Vector3d, 8> corners_of(const Bounds& bounds) {
  std::array<Vector3d, 8> corners;
  for (int i = 0; i < 8; ++i) corners[i] = bounds.corner(static_cast<Bounds::CornerType>(i));
  return corners;
}

Camera frame_points(std::span<const Vector3d> points, double aspect, const Vector3d& direction) {
  particles::require_positive("aspect", aspect);
  particles::require(direction.allFinite() && direction.norm() > 0, "the view's direction", direction.norm(),
                     "finite and not 0");
  Bounds box;
  for (const Vector3d& point : points) box.extend(point);
  const double size = box.isEmpty() ? 0 : box.sizes().maxCoeff();
  particles::require(std::isfinite(size) && size < 1e100, "the size of what is to be seen", size,
                     "at most 1e100 m");
  if (size < kNoSize) {
    if (box.isEmpty()) box.extend(Vector3d::Zero());
    return frame_points(
        std::array{Vector3d(box.min().array() - kSmallest), Vector3d(box.max().array() + kSmallest)}, aspect,
        direction);
  }

  Camera camera;
  const double tangent_y = kFramed * std::tan(camera.field_of_view / 2), tangent_x = aspect * tangent_y;
  const Vector3d back = direction.normalized();
  if (back.head<2>().norm() < 1e-3) camera.up = Vector3d(0, 1, 0);
  const Eigen::Matrix3d axes = view_axes(back, camera.up);

  // In the camera's axes a point (x, y, z) is left of the picture's right side if x - eye_x <= (eye_z - z)
  // tangent_x, and so on. Each side takes the largest value of a point.
  const Vector3d middle = box.center();
  double right = -1e300, left = -1e300, top = -1e300, bottom = -1e300;
  for (const Vector3d& at : points) {
    const Vector3d p = axes * (at - middle);
    right = std::max(right, p[0] + p[2] * tangent_x);
    left = std::max(left, -p[0] + p[2] * tangent_x);
    top = std::max(top, p[1] + p[2] * tangent_y);
    bottom = std::max(bottom, -p[1] + p[2] * tangent_y);
  }
  const double depth = std::max((right + left) / (2 * tangent_x), (top + bottom) / (2 * tangent_y));
  const Vector3d across((right - left) / 2, (top - bottom) / 2, 0);
  camera.target = middle + axes.transpose() * across;
  camera.eye = camera.target + depth * back;
  return camera;
}

Camera frame_camera(const Bounds& bounds, double aspect, const Vector3d& direction) {
  Bounds box = bounds;
  if (box.isEmpty()) box.extend(Vector3d::Zero());
  if (box.sizes().maxCoeff() < kNoSize) {
    box.min().array() -= kSmallest;
    box.max().array() += kSmallest;
  }
  return frame_points(corners_of(box), aspect, direction);
}

}  // namespace hair
