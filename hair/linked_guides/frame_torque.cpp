#include "hair/linked_guides/frame_torque.h"

#include <algorithm>
#include <utility>

#include "hair/strand/turns.h"

namespace hair {
namespace {

Vector3d numbers_of(Input x, int i) {
  return x.segment<3>(3 * Eigen::Index{i});
}

// The turn of a link's arm with its guide.
struct Turning {
  Turning(Input x, int a, int root, const Vector3d& the_arm) : arm(the_arm) {
    const Vector3d chord = numbers_of(x, a) - numbers_of(x, root);
    const double r = chord.norm();
    if (r > 0) way = chord / (r * r);
  }
  Vector3d moves(const Vector3d& dx) const { return way.cross(dx).cross(arm); }  // e
  Vector3d transposed(const Vector3d& d) const { return arm.cross(d).cross(way); }

  Vector3d arm, way = Vector3d::Zero();  // c / r; 0 at the root, whose frame is the head's
};

}  // namespace

FrameTorque::FrameTorque(const std::vector<StaticLink>& links, std::vector<int> roots)
    : links_(links), roots_(std::move(roots)), stiffness_(static_cast<Eigen::Index>(links.size())) {}

void FrameTorque::hold(Input largest) {
  for (std::size_t l = 0; l < links_.size(); ++l) {
    const auto at = static_cast<Eigen::Index>(l);
    stiffness_[at] = links_[l].stiffness * link_strength(links_[l], largest[at]);
  }
}

void FrameTorque::add_force(std::span<const Matrix3d> frames, Input x, Output f) const {
  for (std::size_t l = 0; l < links_.size(); ++l) {
    const int a = links_[l].a, b = links_[l].b;
    const double k = stiffness_[static_cast<Eigen::Index>(l)];
    const Turning turning(x, a, roots_[l], frames[a] * links_[l].offset);
    const Vector3d d = numbers_of(x, b) - numbers_of(x, a) - turning.arm, force = k * turning.transposed(d);
    f.segment<3>(3 * Eigen::Index{a}) += force;
    f.segment<3>(3 * Eigen::Index{roots_[l]}) -= force;
  }
}

void FrameTorque::add_product(std::span<const Matrix3d> frames, Input x, Input dx, Output df) const {
  for (std::size_t l = 0; l < links_.size(); ++l) {
    const int a = links_[l].a, b = links_[l].b;
    const double k = stiffness_[static_cast<Eigen::Index>(l)];
    const Turning turning(x, a, roots_[l], frames[a] * links_[l].offset);
    const Vector3d da = numbers_of(dx, a), e = turning.moves(da - numbers_of(dx, roots_[l])),
                   at_a = k * turning.transposed(numbers_of(dx, b) - da - e);
    df.segment<3>(3 * Eigen::Index{b}) += k * e;
    df.segment<3>(3 * Eigen::Index{a}) += at_a - k * e;
    df.segment<3>(3 * Eigen::Index{roots_[l]}) -= at_a;
  }
}

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
