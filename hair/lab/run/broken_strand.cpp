#include "hair/lab/run/broken_strand.h"

#include <algorithm>
#include <cmath>

#include "hair/render/view.h"

namespace hair {

namespace {

const Colour kRed(0.8f, 0.02f, 0.02f);               // linear
constexpr double kBorder = 0.95, kThickness = 5e-3;  // times half a picture, and the target's distance

}  // namespace

void mark_broken(Drawing& drawing, int strand, const Camera& camera, double aspect) {
  const StrandsDrawing& hair = drawing.strands;
  if (strand < 0 || static_cast<std::size_t>(strand) >= hair.sizes.size()) return;
  const Vector3d back = camera.eye - camera.target;
  const double far = back.norm(), y = kBorder * std::tan(camera.field_of_view / 2), x = aspect * y;
  const Eigen::Matrix3d axes = view_axes(back / far, camera.up);
  const auto shown = [&](const Vector3d& point) -> Vector3d {
    Vector3d seen = axes * (point - camera.eye);
    seen.z() = std::clamp(seen.z(), -2 * far, -far / 2);
    seen.x() = std::clamp(seen.x(), seen.z() * x, -seen.z() * x);
    seen.y() = std::clamp(seen.y(), seen.z() * y, -seen.z() * y);
    return camera.eye + axes.transpose() * seen;
  };
  std::size_t first = 0;
  for (int s = 0; s < strand; ++s) first += static_cast<std::size_t>(hair.sizes[static_cast<std::size_t>(s)]);
  const auto count = static_cast<std::size_t>(hair.sizes[static_cast<std::size_t>(strand)]);
  for (std::size_t i = first; i + 1 < first + count; ++i)
    if (hair.points[i].allFinite() && hair.points[i + 1].allFinite())
      drawing.tubes.push_back({shown(hair.points[i]), shown(hair.points[i + 1]), kThickness * far / 2, kRed});
}

}  // namespace hair
