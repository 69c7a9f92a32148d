#include "hair/rigid_links/link_momenta.h"

#include <algorithm>
#include <cmath>

#include "hair/rigid_links/tree_system.h"

namespace hair {

namespace {

constexpr double kSpare = 0.003;        // a sixteenth of the gain that is reported (hair/strand/watch.cpp)
constexpr double kLongCalm = 1.0 / 60;  // s

}  // namespace

LinkMomenta::LinkMomenta(const LinkTree& tree, const TreeForces& forces) : gravity_(forces.gravity) {
  if (!forces.bend_rigidity) return;
  bend_rigidity_ = *forces.bend_rigidity;
  double mass = 0, length = 0;
  for (int i = 0; i < tree.links(); ++i) {
    mass += tree.shapes()[i].mass;
    lengths_.push_back(forces.rods[i].norm());
    length += lengths_.back();
  }
  line_density_ = mass / length;
  shortest_ = *std::min_element(lengths_.begin() + 1, lengths_.end());
  unit_ = mass * gravity_.norm() * length;
  before_.velocities.resize(lengths_.size());
  now_ = before_;
}

void LinkMomenta::begin() {
  now_.in_use = before_.in_use && before_.calm < kLongCalm;
}

void LinkMomenta::add_to(TreeMotion& motion, double h) const {
  double beyond = 0;
  for (std::size_t i = lengths_.size() - 1; i >= 1; --i) {
    Link& link = motion.links[i];
    LinkPass& pass = motion.passes[i];
    const double mass = motion.tree().shapes()[i].mass;
    pass.c.linear.setZero();
    pass.bias.force = -link.external.force - mass / h * (before_.velocities[i].linear - pass.v.linear);

    const Vector3d u = motion.frames()[i].axes.col(2);
    const double holds = std::max(0.0, lengths_[i] * (mass / 2 + beyond) * gravity_.dot(u));
    const Matrix3d across = h * holds * (Matrix3d::Identity() - u * u.transpose());
    link.inertia.J += h * across;
    pass.bias.torque += across * pass.v.angular;
    beyond += mass;
  }
}

bool LinkMomenta::ask_for(const TreeMotion& motion, Input rates, Input accelerations, double h) {
  const LinkPass& root = motion.passes[0];
  now_.velocities[0] = root.v + h * root.a;
  double made = 0, moving = 0, pull = 0;
  for (std::size_t i = 1; i < lengths_.size(); ++i) {
    const Link& link = motion.links[i];
    const LinkPass& pass = motion.passes[i];
    const double mass = motion.tree().shapes()[i].mass;
    const Vector3d w = rates.segment<3>(link.first) + h * accelerations.segment<3>(link.first);
    SpatialMotion& after = now_.velocities[i];
    after = to_child(now_.velocities[i - 1], link.r) + SpatialMotion{w, w.cross(link.d)};
    const Vector3d end = after.linear - now_.velocities[0].linear;
    moving += mass / 2 * end.squaredNorm();
    pull = std::max(pull, -motion.frames()[i].axes.col(2).dot((pass.inertia * pass.a + pass.bias).force));
    if (!before_.known) continue;
    const Vector3d now = pass.v.linear - root.v.linear, kept = before_.velocities[i].linear - root.v.linear;
    const Vector3d hc = now_.in_use ? Vector3d(now - kept) : pass.v.linear + h * pass.a.linear - after.linear;
    made += mass / 2 * (now.squaredNorm() - kept.squaredNorm() - hc.dot(now + end));
  }
  const double spare = kSpare * (unit_ + moving);
  const bool pulled = pull > tension(h);
  if (now_.in_use) made = std::min(made, 0.0);
  now_.made = std::max(0.0, before_.made + made);
  if (before_.known && !now_.in_use && (pulled || now_.made > spare)) return now_.in_use = true;
  const bool begins = now_.in_use && !before_.in_use;
  now_.calm = pulled || begins || now_.made > spare / 2 ? 0 : before_.calm + h;
  now_.known = true;
  return false;
}

// (2): the smallest T over k^2.
double LinkMomenta::tension(double h) const {
  const double k2 = std::min(2 / h * std::sqrt(line_density_ / bend_rigidity_), 4 / (shortest_ * shortest_));
  return 4 * line_density_ / (h * h * k2) + bend_rigidity_ * k2;
}

}  // namespace hair
