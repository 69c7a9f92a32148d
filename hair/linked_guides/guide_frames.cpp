#include "hair/linked_guides/guide_frames.h"

#include <algorithm>

#include "hair/strand/turns.h"

namespace hair {

void guide_frames(particles::Input x, const Eigen::Vector3d& tangent, const Eigen::Vector3d& normal,
                  std::span<Eigen::Matrix3d> frames) {
  frames[0] << tangent, normal, tangent.cross(normal);
  Eigen::Vector3d direction = tangent;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(3 * i);
    const Eigen::Vector3d chord = x.segment<3>(at) - x.head<3>();
    const double length = chord.norm();
    frames[i] = frames[i - 1];
    if (!(length > 0)) continue;
    const Eigen::Vector3d next = chord / length;
    frames[i] = turn_between(direction, next) * frames[i - 1];
    direction = next;
  }
}

void guide_tangents(particles::Input x, particles::Output tangents) {
  const Eigen::Index last = x.size() - 3;
  for (Eigen::Index at = 0; at <= last; at += 3) {
    const Eigen::Vector3d along =
        x.segment<3>(std::min(at + 3, last)) - x.segment<3>(std::max(at - 3, Eigen::Index{0}));
    const double length = along.norm();
    tangents.segment<3>(at).setZero();
    if (length > 0) tangents.segment<3>(at) = along / length;
  }
}

}  // namespace hair
