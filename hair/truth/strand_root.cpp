#include "hair/truth/strand_root.h"

namespace hair {

namespace {

RootMotion start_of(const StrandStart& start) {
  return {start.state.x.head<3>(), start.state.v.head<3>(), Vector3d::Zero(), start.strand.root_tangent,
          start.root_normal};
}

}  // namespace

StrandRoot::StrandRoot(const Scene& scene) : start_(start_of(scene.hair.strands.at(0))) {
  // The last motion counts, as in a simulation.
  for (const Rider& rider : scene.riders)
    if (!rider.strands.empty()) motion_ = &rider.motion;
  if (motion_) turns_ = scene.hair.strands[0].strand.clamped && hair::turns(*motion_);
  start_span(0);
}

std::vector<double> StrandRoot::breaks() const {
  std::vector<double> times;
  if (motion_)
    for (const Key& key : motion_->keys) times.push_back(key.time);
  return times;
}

void StrandRoot::start_span(double time) {
  if (!motion_) return;
  next_key_ = 0;
  while (next_key_ < motion_->keys.size() && motion_->keys[next_key_].time <= time) ++next_key_;
}

RootMotion StrandRoot::at(double time) const {
  RootMotion root = start_;
  if (!motion_) {
    root.position += time * root.velocity;
    return root;
  }
  const Way way = way_at(*motion_, time);
  root.position = way(start_.position);
  root.velocity.setZero();
  if (turns_) {
    root.tangent = (way.rotation * root.tangent).normalized();
    root.normal = (way.rotation * root.normal).normalized();
  }
  if (next_key_ == 0 || next_key_ == motion_->keys.size()) return root;

  // Between two keys Motion::at covers the part w = s^2 (3 - 2s) of the way, and turns by w times an angle
  // about an axis: dp/dw = turn x (p - position) + (to's position - from's position), and so on.
  const Key &from = motion_->keys[next_key_ - 1], &to = motion_->keys[next_key_];
  const double length = to.time - from.time, s = (time - from.time) / length;
  const double dw = 6 * s * (1 - s) / length, ddw = (6 - 12 * s) / (length * length);
  const Eigen::AngleAxisd turn(to.pose.rotation * from.pose.rotation.conjugate());
  const Vector3d spin = turn.angle() * turn.axis();
  const Vector3d arm = root.position - way.to;
  const Vector3d along = spin.cross(arm) + to.pose.position - from.pose.position;
  root.velocity = dw * along;
  root.acceleration = ddw * along + dw * dw * spin.cross(spin.cross(arm));
  return root;
}

}  // namespace hair
