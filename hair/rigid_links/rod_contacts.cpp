#include "hair/rigid_links/rod_contacts.h"

#include <algorithm>
#include <utility>

namespace hair {

void RodContacts::find(std::span<const RodPoint> points, const std::vector<Obstacle>& obstacles,
                       const Vector3d& gravity, double h) {
  std::swap(pressed_, before_);
  h_ = h;
  contacts_ = 0;
  deepest_ = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const RodPoint& point = points[i];
    pressed_[i] = {};
    for (const Obstacle& obstacle : obstacles) {
      // Obstacles have moved already: the point is where it would be if it had moved with this one.
      const Vector3d u = point.v - obstacle.velocity, x = point.x + h * obstacle.velocity;
      const auto [gap, n] = surface_at(obstacle, x);
      if (gap >= 0 && surface_at(obstacle, x + h * (u + h * gravity)).distance >= 0) continue;
      if (pressed_[i].by && pressed_[i].gap <= gap) continue;  // of several obstacles the nearest
      pressed_[i] = {&obstacle,
                     n,
                     obstacle.velocity,
                     point.mass * kContactRate * kContactRate,
                     std::max(gap, -h * kPushOut),
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

void RodContacts::add(std::span<const RodPoint> points, std::vector<LinkForce>& forces) const {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Pressed& one = pressed_[i];
    if (!one.by) continue;
    const Eigen::Matrix3d across = one.normal * one.normal.transpose();
    const Eigen::Matrix3d damping = one.friction * (Eigen::Matrix3d::Identity() - across);
    const Vector3d still = one.k * (h_ * one.normal.dot(one.velocity) - one.gap) * one.normal;
    forces.push_back({points[i].link, Vector3d(0, 0, points[i].along),
                      still - damping * (points[i].v - one.velocity), one.k * across, damping});
  }
}

// Points that have not arrived yet come first: without them, others may be pressed again.
bool RodContacts::let_go(std::span<const RodPoint> points, const std::vector<LinkPass>& links) {
  bool outside = false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    Pressed& one = pressed_[i];
    if (!one.by) continue;
    // As the step has it: with the point where it was.
    const SpatialMotion& a = links[points[i].link].a;
    const Vector3d v = points[i].v + h_ * (a.linear + a.angular.cross(points[i].arm));
    one.pressure = -one.k * (one.gap + h_ * one.normal.dot(v - one.velocity));
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

}  // namespace hair
