#include "hair/scene/toy_energy.h"

#include <algorithm>

#include "particles/system.h"

namespace hair {

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
