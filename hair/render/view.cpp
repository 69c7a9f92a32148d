#include "hair/render/view.h"

#include <cmath>

#include "particles/require.h"

namespace hair {

namespace {

using particles::require;

// In units of the distance from eye to target. 24 bits of depth between them resolve a hundred-thousandth of
// it at the target.
constexpr double kNear = 0.01, kFar = 100;
constexpr double kFarthestDrawn = 1e6;

}  // namespace

Eigen::Matrix3d view_axes(const Vector3d& back, const Vector3d& up) {
  Eigen::Matrix3d axes;
  axes.row(2) = back.normalized();
  axes.row(0) = up.cross(back).normalized();
  axes.row(1) = axes.row(2).cross(axes.row(0));
  return axes;
}

View::View(const Camera& camera, double aspect) : eye_(camera.eye) {
  require(camera.eye.allFinite(), "the norm of the camera's eye", camera.eye.norm(), "finite");
  const Vector3d back = camera.eye - camera.target;
  unit_ = back.norm();
  require(unit_ > 1e-100 && unit_ < 1e100, "the camera's distance to its target", unit_, "1e-100 to 1e100 m");
  require(camera.field_of_view > 0.001 && camera.field_of_view < 3, "the camera's field of view",
          camera.field_of_view, "0.001 to 3 rad");
  const double sine = (back / unit_).cross(camera.up).norm() / camera.up.norm();
  require(sine > 1e-6, "the sine of the angle between the camera's up and its view", sine, "more than 1e-6");
  axes_ = view_axes(back / unit_, camera.up.normalized());
  tangent_y_ = std::tan(camera.field_of_view / 2);
  tangent_x_ = aspect * tangent_y_;
}

Eigen::Vector3f View::at(const Vector3d& point) const {
  return (axes_ * ((point - eye_) / unit_)).cwiseMax(-kFarthestDrawn).cwiseMin(kFarthestDrawn).cast<float>();
}

float View::length(double metres) const {
  return static_cast<float>(std::min(metres / unit_, kFarthestDrawn));
}

float View::distance(float depth) const {
  return static_cast<float>(2 * kFar * kNear /
                            (kFar + kNear - (2 * static_cast<double>(depth) - 1) * (kFar - kNear)));
}

Eigen::Matrix4f View::projection() const {
  Eigen::Matrix4f matrix = Eigen::Matrix4f::Zero();
  matrix(0, 0) = static_cast<float>(1 / tangent_x_);
  matrix(1, 1) = static_cast<float>(1 / tangent_y_);
  matrix(2, 2) = static_cast<float>(-(kFar + kNear) / (kFar - kNear));
  matrix(2, 3) = static_cast<float>(-2 * kFar * kNear / (kFar - kNear));
  matrix(3, 2) = -1;
  return matrix;
}

}  // namespace hair
