#include "hair/strand/implicit_contacts.h"

#include <algorithm>
#include <utility>

namespace hair {

void ImplicitContacts::find(std::span<const ContactPoint> points, const std::vector<Obstacle>& obstacles,
                            const Vector3d& gravity, double h) {
  std::swap(pressed_, before_);
  h_ = h;
  contacts_ = 0;
  deepest_ = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ContactPoint& point = points[i];
    pressed_[i] = {};
    for (const Obstacle& obstacle : obstacles) {
      // Obstacles have moved already, so the point is moved with this obstacle.
      const Vector3d velocity = velocity_at(obstacle, point.x);
      const Vector3d u = point.v - velocity, x = point.x + h * velocity;
      const auto [gap, n] = surface_at(obstacle, x);
      if (gap >= 0 && surface_at(obstacle, x + h * (u + h * gravity)).distance >= 0) continue;
      if (pressed_[i].by && pressed_[i].gap <= gap) continue;  // the nearest obstacle counts
      pressed_[i] = {
          &obstacle, n, velocity, point.mass * kContactRate * kContactRate, std::max(gap, -h * kPushOut),
          -gap};
      const Pressed& last = before_[i];
      if (last.by != &obstacle) continue;
      deepest_ = std::max(deepest_, std::min(last.depth, -gap));
      const double slip = (u - n.dot(u) * n).norm();
      pressed_[i].friction =
          obstacle.friction * std::min(last.pressure, last.k * kRestingDepth) / std::max(slip, kCreep);
    }
    contacts_ += pressed_[i].by != nullptr;
  }
}

std::span<const ContactForce> ImplicitContacts::forces(std::span<const ContactPoint> points) {
  forces_.clear();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Pressed& one = pressed_[i];
    if (!one.by) continue;
    const Eigen::Matrix3d across = one.normal * one.normal.transpose();
    const Eigen::Matrix3d damping = one.friction * (Eigen::Matrix3d::Identity() - across);
    const Vector3d still = one.k * (h_ * one.normal.dot(one.velocity) - one.gap) * one.normal;
    forces_.push_back({i, still - damping * (points[i].v - one.velocity), one.k * across, damping});
  }
  return forces_;
}

// Releases points that have not arrived yet first: without them, others may be pressed again.
bool ImplicitContacts::let_go(std::span<const Vector3d> velocities) {
  bool outside = false;
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    Pressed& one = pressed_[i];
    if (!one.by) continue;
    one.pressure = -one.k * (one.gap + h_ * one.normal.dot(velocities[i] - one.velocity));
    outside |= one.pressure < 0 && one.gap > 0;
  }
  bool any = false;
  for (Pressed& one : pressed_) {
    if (!one.by || one.pressure >= 0 || (outside && one.gap <= 0)) continue;
    one.by = nullptr;
    --contacts_;
    any = true;
  }
  return any;
}

ContactWork ImplicitContacts::work(std::span<const Vector3d> velocities) const {
  ContactWork sum;
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    const Pressed& one = pressed_[i];
    if (!one.by) continue;
    const Vector3d u = velocities[i] - one.velocity;
    const Vector3d impulse =
        h_ * (one.pressure * one.normal - one.friction * (u - one.normal.dot(u) * one.normal));
    sum.impulse += impulse;
    sum.work += impulse.dot(one.velocity);
  }
  return sum;
}

}  // namespace hair
