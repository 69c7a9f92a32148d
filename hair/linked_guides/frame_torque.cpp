#include "hair/linked_guides/frame_torque.h"

#include <utility>

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

}  // namespace hair
