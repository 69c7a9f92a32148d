#include "hair/rigid_links/link_energy.h"

#include "hair/strand/turns.h"

namespace hair {

using Eigen::Quaterniond;

namespace {

double mass_of(const LinkTree& tree) {
  double sum = 0;
  for (const LinkShape& shape : tree.shapes()) sum += shape.mass;
  return sum;
}

}  // namespace

LinkEnergy::LinkEnergy(const LinkStrand& strand, bool implicit)
    : strand_(strand),
      implicit_(implicit),
      rates_before_(strand.rates),
      mass_(mass_of(strand.tree)),
      watch_(mass_, strand.length.sum(), strand.forces.gravity.norm(), strand.forces.drag) {}

// Reads the energies of the present strand, relative to its base.
void LinkEnergy::read(TreeSystem& system, bool found) {
  TreeMotion& motion = system.motion();
  energies_ = {};
  momentum_.setZero();
  if (!found) {
    motion.place(strand_.base, strand_.q);
    outward_velocities(motion.links, strand_.rates, motion.passes);
  }
  for (std::size_t i = 1; i < motion.links.size(); ++i) {
    const double mass = strand_.tree.shapes()[i].mass;
    const SpatialMotion& v = found ? system.momenta().velocities()[i] : motion.passes[i].v;
    const Vector3d velocity = v.linear - strand_.base.velocity.linear;
    energies_.kinetic +=
        (mass * velocity.squaredNorm() + v.angular.dot(motion.links[i].tensor * v.angular)) / 2;
    momentum_ += mass * velocity;
  }
  motion.place(strand_.base, strand_.q);
  for (std::size_t i = 1; i < motion.links.size(); ++i) {
    const LinkFrame& frame = motion.frames()[i];
    energies_.weight -=
        strand_.tree.shapes()[i].mass * strand_.forces.gravity.dot(frame.position - strand_.base.position);
    energies_.elastic += strand_.forces.springs[i].energy(frame.turn);
  }
}

void LinkEnergy::before_step(const SpatialMotion& base, TreeSystem& system) {
  rates_before_ = strand_.rates;
  base_before_ = strand_.base.velocity;
  base_ = base;
  root_velocity_ = mean(base_before_.linear, base.linear);
  if (!watch_.begun()) {
    read(system, false);
    watch_.begin(energies_);
  }
  momentum_before_ = momentum_;
}

void LinkEnergy::after_step(TreeSystem& system, double h, const ContactWork* contacts) {
  const LinkPass& root = system.motion().passes.front();
  const Vector3d torque = (root.inertia * root.a + root.bias).torque;
  const Vector3d changes = base_.linear - base_before_.linear;
  double work = h * torque.dot(mean(base_before_.angular, base_.angular));
  if (strand_.forces.drag > 0) work += drag_work(system, h);
  work += damping_work(system.motion(), h);
  if (contacts) work += contacts->seen_from(root_velocity_);
  read(system, implicit_);
  const Vector3d momentum_after = implicit_ ? Vector3d(momentum_before_ - mass_ * changes) : momentum_;
  work -= changes.dot(momentum_before_ + momentum_after) / 2;
  watch_.after_step(energies_, work, contacts != nullptr, h);
}

double LinkEnergy::drag_work(const TreeSystem& system, double h) const {
  const TreeMotion& motion = system.motion();
  double power = 0;
  for (std::size_t i = 1; i < motion.passes.size(); ++i) {
    const SpatialMotion &before = motion.passes[i].v, &pushed = motion.passes[i].a;
    const SpatialMotion after = implicit_ ? system.momenta().velocities()[i] : before + h * pushed;
    const SpatialMotion& feels = implicit_ ? after : before;
    const Vector3d e = motion.frames()[i].axes * strand_.forces.rods[i];
    const double squared = e.squaredNorm(), c = strand_.forces.drag * std::sqrt(squared);
    const Vector3d turning = squared * feels.angular - e.dot(feels.angular) * e;
    power -=
        c * (feels.linear - strand_.forces.wind).dot(mean(before.linear, after.linear) - root_velocity_) +
        c / 12 * turning.dot(mean(before.angular, after.angular));
  }
  return h * power;
}

double LinkEnergy::damping_work(const TreeMotion& motion, double h) const {
  double power = 0;
  for (std::size_t i = 1; i < motion.passes.size(); ++i) {
    const Matrix3d& damping = strand_.forces.springs[i].damping;
    if (damping.isZero(0)) continue;
    const Quaterniond back = motion.frames()[i].joint_axes.conjugate();
    const Eigen::Index first = motion.links[i].first;
    const Vector3d rate =
        back * mean(Vector3d(rates_before_.segment<3>(first)), Vector3d(strand_.rates.segment<3>(first)));
    power -= rate.dot(damping * rate);
  }
  return h * power;
}

// The velocity for the work of a step's forces.
Vector3d LinkEnergy::mean(const Vector3d& before, const Vector3d& after) const {
  return implicit_ ? after : Vector3d((before + after) / 2);
}

}  // namespace hair
