#include "hair/scene/toy_body.h"

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

}  // namespace hair
