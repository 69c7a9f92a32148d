#include "hair/mass_spring/spring_energy.h"

#include <algorithm>

namespace hair {

namespace {

double energy(const std::vector<const particles::Force*>& parts, const Eigen::VectorXd& x) {
  double sum = 0;
  for (const particles::Force* part : parts) sum += part->energy(x);
  return sum;
}

}  // namespace

SpringEnergy::SpringEnergy(const MovingStrand& moving, const Vector3d& gravity, double drag,
                           bool with_stretching, int every)
    : moving_(moving),
      gravity_(gravity),
      with_stretching_(with_stretching),
      every_(every),
      watch_(moving.strand.mass.sum(), moving.strand.rest_length.sum(), gravity.norm(), drag) {}

double SpringEnergy::kinetic() const {
  const Eigen::VectorXd& v = moving_.state.v;
  double twice = 0;
  for (int i = 1; i < moving_.strand.count(); ++i)
    twice += moving_.strand.mass[i] * (v.segment<3>(3 * i) - root_velocity_).squaredNorm();
  return twice / 2;
}

double SpringEnergy::weight() const {
  const Eigen::VectorXd& x = moving_.state.x;
  Vector3d moment = Vector3d::Zero();
  for (int i = 1; i < moving_.strand.count(); ++i)
    moment += moving_.strand.mass[i] * (x.segment<3>(3 * i) - x.head<3>());
  return -gravity_.dot(moment);
}

Energies SpringEnergy::read() {
  const Eigen::VectorXd& x = moving_.state.x;
  const double stretching = energy(moving_.stretching, x);
  bending_ = energy(moving_.bending, x);
  return {.kinetic = kinetic(),
          .weight = weight(),
          .elastic = bending_ + (with_stretching_ ? stretching : 0),
          .aside = with_stretching_ ? 0 : stretching,
          .unmoved = unmoved_};
}

void SpringEnergy::restart() {
  watch_.restart();
  open_ = 0;
  work_ = time_ = 0;
  in_contact_ = false;
}

void SpringEnergy::before_step() {
  const Vector3d velocity = moving_.state.v.head<3>();
  const bool moved = velocity != root_velocity_, begins = !watch_.begun();
  if (open_ > 0 && (moved || turned_)) close();
  root_velocity_ = velocity;
  if (begins) {
    watch_.begin(read());
  } else if (moved || turned_) {
    Energies now = watch_.now();
    if (moved) now.kinetic = kinetic();
    if (turned_) {
      now.elastic -= bending_;
      bending_ = energy(moving_.bending, moving_.state.x);
      now.elastic += bending_;
    }
    watch_.root_moved(now);
  }
  turned_ = false;
}

void SpringEnergy::moved(double h, particles::Input x_before, particles::Input v_before) {
  const auto& [x, v] = moving_.state;
  double twice = 0;
  for (int i = 1; i < moving_.strand.count(); ++i) {
    const Vector3d velocity = (v_before.segment<3>(3 * i) + v.segment<3>(3 * i)) / 2;
    twice +=
        moving_.strand.mass[i] *
        (velocity - root_velocity_).dot(velocity - (x.segment<3>(3 * i) - x_before.segment<3>(3 * i)) / h);
  }
  unmoved_ = std::max(twice / 2, 0.0);
}

void SpringEnergy::after_step(double h, particles::Input v_before, const ContactWork* contacts) {
  if (moving_.drag) work_ += moving_.drag->work(h, v_before, moving_.state.v, root_velocity_);
  if (contacts) {
    work_ += contacts->seen_from(root_velocity_);
    in_contact_ = true;
  }
  time_ += h;
  if (++open_ == every_) close();
}

void SpringEnergy::close() {
  watch_.after_step(read(), work_, in_contact_, time_);
  open_ = 0;
  work_ = time_ = 0;
  in_contact_ = false;
}

}  // namespace hair
