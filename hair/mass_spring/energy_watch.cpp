#include "hair/mass_spring/energy_watch.h"

#include <algorithm>

namespace hair {

namespace {

// m/s. The energy of a strand that moves as slowly counts as had: rounding alone is far below it, and is no gain.
constexpr double kUnseen = 1e-3;

double energy(const std::vector<const particles::Force*>& parts, const Eigen::VectorXd& x) {
  double sum = 0;
  for (const particles::Force* part : parts) sum += part->energy(x);
  return sum;
}

}  // namespace

EnergyWatch::EnergyWatch(const MovingStrand& moving, const Vector3d& gravity, bool with_stretching)
    : moving_(moving), gravity_(gravity), with_stretching_(with_stretching) {}

double EnergyWatch::kinetic() const {
  const Eigen::VectorXd& v = moving_.state.v;
  double twice = 0;
  for (int i = 1; i < moving_.strand.count(); ++i)
    twice += moving_.strand.mass[i] * (v.segment<3>(3 * i) - root_velocity_).squaredNorm();
  return twice / 2;
}

double EnergyWatch::weight() const {
  const Eigen::VectorXd& x = moving_.state.x;
  Vector3d moment = Vector3d::Zero();
  for (int i = 1; i < moving_.strand.count(); ++i)
    moment += moving_.strand.mass[i] * (x.segment<3>(3 * i) - x.head<3>());
  return -gravity_.dot(moment);
}

EnergyWatch::Parts EnergyWatch::read() const {
  const Eigen::VectorXd& x = moving_.state.x;
  return {kinetic(), weight(), energy(moving_.bending, x), energy(moving_.stretching, x)};
}

void EnergyWatch::begin() {
  begun_ = true;
  root_velocity_ = moving_.state.v.head<3>();
  turned_ = false;
  now_ = read();
  const Strand& strand = moving_.strand;
  scale_ = now_.kinetic + now_.bending + now_.stretching +
           strand.mass.sum() * (gravity_.norm() * strand.rest_length.sum() + kUnseen * kUnseen / 2);
  // What is stretched at the start may move the strand.
  free_ = last_ = with_stretching_ ? 0 : -now_.stretching;
  in_contact_ = gain_ = contact_gain_ = stretching_ = 0;
  steps_ = 0;
}

double EnergyWatch::kept(const Parts& parts) const {
  return parts.kinetic + parts.weight + parts.bending + (with_stretching_ ? parts.stretching : 0);
}

void EnergyWatch::came_in(double work) {
  scale_ += std::max(work, 0.0);
}

void EnergyWatch::before_step() {
  if (!begun_) return begin();
  last_ = 0;
  if (const Vector3d velocity = moving_.state.v.head<3>(); velocity != root_velocity_) {
    root_velocity_ = velocity;
    const double before = now_.kinetic;
    now_.kinetic = kinetic();
    came_in(now_.kinetic - before);
  }
  if (turned_) {
    const double before = now_.bending;
    now_.bending = energy(moving_.bending, moving_.state.x);
    came_in(now_.bending - before);
    turned_ = false;
  }
}

void EnergyWatch::after_step(double h, particles::Input v_before, const ContactWork* contacts) {
  const Parts before = now_;
  now_ = read();
  double work = 0;
  if (moving_.drag) work += moving_.drag->work(h, v_before, moving_.state.v, root_velocity_);
  if (contacts) work += contacts->work - contacts->impulse.dot(root_velocity_);
  came_in(work);
  const double gained = kept(now_) - kept(before) - work;
  last_ += gained;
  (contacts ? in_contact_ : free_) += gained;
  stretching_ += now_.stretching / scale_;
  ++steps_;
  gain_ = std::max(gain_, free_ / scale_);
  contact_gain_ = std::max(contact_gain_, in_contact_ / scale_);
}

}  // namespace hair
