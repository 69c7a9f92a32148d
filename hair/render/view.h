// The view of a camera in its own axes: x to the right, y up, z towards the eye, which is the origin. The
// unit is the distance from eye to target, so scenes of a millimetre and of a kilometre have the same
// numbers.
#pragma once

#include "hair/render/camera.h"

namespace hair {

// Rows: right, up, back. `back` and `up` may not be parallel.
Eigen::Matrix3d view_axes(const Vector3d& back, const Vector3d& up);

class View {
 public:
  // Throws std::invalid_argument for a camera whose direction is undefined.
  View(const Camera& camera, double aspect);

  // The coordinates of a point. They stay finite for very distant points.
  Eigen::Vector3f at(const Vector3d& point) const;
  Eigen::Vector3f direction(const Vector3d& direction) const { return (axes_ * direction).cast<float>(); }
  float length(double metres) const;

  float tangent_x() const { return static_cast<float>(tangent_x_); }  // the tangent of half the angle of view
  float tangent_y() const { return static_cast<float>(tangent_y_); }

  // The distance along the view, in its unit, for a depth (0 to 1) in a picture.
  float distance(float depth) const;

  // From the view's axes to clip space, column by column.
  Eigen::Matrix4f projection() const;

 private:
  Eigen::Matrix3d axes_;
  Vector3d eye_;
  double unit_, tangent_x_, tangent_y_;
};

}  // namespace hair
