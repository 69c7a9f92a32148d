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
  for (std::size_t corner = 0; corner < 8; ++corner)
    corners[corner] = Vector3d((corner & 1) != 0 ? bounds.high[0] : bounds.low[0],
                               (corner & 2) != 0 ? bounds.high[1] : bounds.low[1],
                               (corner & 4) != 0 ? bounds.high[2] : bounds.low[2]);
  return corners;
}

Camera frame_points(std::span<const Vector3d> points, double aspect, const Vector3d& direction) {
  particles::require_positive("aspect", aspect);
  particles::require(direction.allFinite() && direction.norm() > 0, "the view's direction", direction.norm(),
                     "finite and not 0");
  Bounds box;
  for (const Vector3d& point : points) box.add(point);
  const double size = box.empty() ? 0 : (box.high - box.low).maxCoeff();
  particles::require(std::isfinite(size) && size < 1e100, "the size of what is to be seen", size,
                     "at most 1e100 m");
  if (size < kNoSize) {
    if (box.empty()) box.add(Vector3d::Zero());
    return frame_points(
        std::array{Vector3d(box.low.array() - kSmallest), Vector3d(box.high.array() + kSmallest)}, aspect,
        direction);
  }

  Camera camera;
  const double tangent_y = kFramed * std::tan(camera.field_of_view / 2), tangent_x = aspect * tangent_y;
  const Vector3d back = direction.normalized();
  if (back.head<2>().norm() < 1e-3) camera.up = Vector3d(0, 1, 0);
  const Eigen::Matrix3d axes = view_axes(back, camera.up);

  // In the camera's axes a point (x, y, z) is left of the picture's right side if x - eye_x <= (eye_z - z)
  // tangent_x, and so on. Each side takes the largest value of a point.
  const Vector3d middle = (box.low + box.high) / 2;
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
  if (box.empty()) box.add(Vector3d::Zero());
  if ((box.high - box.low).maxCoeff() < kNoSize) {
    box.low.array() -= kSmallest;
    box.high.array() += kSmallest;
  }
  return frame_points(corners_of(box), aspect, direction);
}

}  // namespace hair
