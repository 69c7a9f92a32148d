#include "hair/scene/toy_body.h"

#include <algorithm>

#include "particles/system.h"

namespace hair {

ToyBody::ToyBody(const particles::Toy& toy, bool watched)
    : moving_(toy, watched), method_(particles::toy_step_of(toy.method)) {
  if (watched) energy_.emplace(moving_);
}

void ToyBody::read(particles::Output q, particles::Output rate) const {
  q = moving_.state.x;
  rate = moving_.state.v;
}

void ToyBody::write(particles::Input q, particles::Input rate) {
  moving_.state.x = q;
  moving_.state.v = rate;
  all_ = {};
  if (energy_) energy_->restart();
}

std::optional<Stage> ToyBody::step(const BodyStep& step, const particles::Scratch& scratch, Work& work) {
  moving_.solves = {};
  if (energy_) energy_->before_step();
  method_.step(moving_, {step.h, step.tolerance}, scratch);
  work.solver_steps += moving_.solves.steps;
  work.solves += moving_.solves.solves;
  work.unconverged += moving_.solves.unconverged;
  all_.solves += moving_.solves.solves;
  all_.unconverged += moving_.solves.unconverged;
  if (is_sound(moving_.state)) {
    if (energy_) energy_->after_step(step.h);
    return {};
  }
  return moving_.dynamics ? Stage::integration : Stage::filter;
}

Sizes ToyBody::sizes() const {
  Sizes sizes;
  if (!energy_) return sizes;
  add(energy_->watch(), sizes);
  sizes[Concern::stretch] = largest_rod_stretch(moving_.toy, moving_.state.x);
  sizes[Concern::unconverged] = moving_.solves.left;
  sizes[Concern::solves] = share_of(all_.unconverged, all_.solves);
  return sizes;
}

const char* ToyBody::solver() const {
  return moving_.toy.constraints.rows() > 0                           ? "P2"
         : moving_.toy.method == particles::ToyMethod::implicit_euler ? "H4"
                                                                      : "";
}

void ToyBody::centre_line(particles::Input q, particles::Input rate, particles::Output x,
                          particles::Output v) const {
  x = q;
  v = rate;
}

BodyMeasures ToyBody::measure(particles::Input q, particles::Input rate) const {
  const particles::Particles& all = moving_.toy.particles;
  return {largest_stretch(moving_.toy, q), particles::kinetic_energy(all, rate), moving_.force.energy(q),
          particles::momentum(all, rate), particles::angular_momentum(all, q, rate)};
}

using particles::Toy;

namespace {

// m: the size of the whole toy at the start.
double length_of(const Toy& toy) {
  Eigen::Vector3d low = toy.start.x.head<3>(), high = low;
  const auto add = [&](const Eigen::Vector3d& point, double around) {
    low = low.cwiseMin(point - Eigen::Vector3d::Constant(around));
    high = high.cwiseMax(point + Eigen::Vector3d::Constant(around));
  };
  for (int i = 0; i < toy.particles.count(); ++i) add(toy.start.x.segment<3>(3 * i), 0);
  for (const particles::Wire& wire : toy.constraints.wires) add(wire.centre, wire.radius);
  return (high - low).norm();
}

bool dissipates(const Toy& toy) {
  return toy.drag > 0 || std::any_of(toy.springs.begin(), toy.springs.end(),
                                     [](const particles::Spring& spring) { return spring.damping > 0; });
}

}  // namespace

ToyEnergy::ToyEnergy(const particles::MovingToy& moving)
    : moving_(moving),
      dissipates_(dissipates(moving.toy)),
      implicit_(moving.toy.method == particles::ToyMethod::implicit_euler),
      nothing_(Eigen::VectorXd::Zero(moving.state.x.size())),
      watch_(moving.toy.particles.mass.sum(), length_of(moving.toy), moving.toy.gravity.norm()) {}

Energies ToyEnergy::read() const {
  const particles::Particles& all = moving_.toy.particles;
  const auto& [x, v] = moving_.state;
  Energies now{.kinetic = particles::kinetic_energy(all, v)};
  for (int i = 0; i < all.count(); ++i)
    now.weight -= all.mass[i] * moving_.toy.gravity.dot(x.segment<3>(3 * i));
  now.elastic = moving_.force.energy(x) - now.weight;
  return now;
}

// In still air, drag is the force minus that at rest.
void ToyEnergy::find_drag(Eigen::VectorXd& drag) {
  const auto& [x, v] = moving_.state;
  drag.setZero(x.size());
  still_.setZero(x.size());
  moving_.force.add_force(x, v, drag);
  moving_.force.add_force(x, nothing_, still_);
  drag -= still_;
  for (int i = 0; i < moving_.toy.particles.count(); ++i)
    drag.segment<3>(3 * i) += moving_.toy.drag * moving_.toy.wind;
}

void ToyEnergy::before_step() {
  if (!watch_.begun()) {
    watch_.begin(read());
    if (dissipates_) find_drag(drag_);
  }
  if (!dissipates_) return;
  v_before_ = moving_.state.v;
  drag_before_.swap(drag_);
}

void ToyEnergy::after_step(double h) {
  double work = 0;
  if (dissipates_) {
    find_drag(drag_);
    const Eigen::VectorXd& v = moving_.state.v;
    work =
        implicit_ ? h / 2 * drag_.dot(v_before_ + v) : h / 2 * (drag_before_.dot(v_before_) + drag_.dot(v));
  }
  watch_.after_step(read(), work, false);
}

}  // namespace hair
