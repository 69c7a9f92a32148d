#include "hair/scene/toy_body.h"

#include "particles/system.h"

namespace hair {

void ToyBody::read(particles::Output q, particles::Output rate) const {
  q = moving_.state.x;
  rate = moving_.state.v;
}

void ToyBody::write(particles::Input q, particles::Input rate) {
  moving_.state.x = q;
  moving_.state.v = rate;
}

std::optional<Stage> ToyBody::step(const BodyStep& step, const particles::Scratch& scratch, Work& work) {
  moving_.solves = {};
  method_.step(moving_, {step.h, step.tolerance}, scratch);
  work.solver_steps += moving_.solves.steps;
  work.unconverged += moving_.solves.unconverged;
  if (is_sound(moving_.state)) return {};
  return moving_.dynamics ? Stage::integration : Stage::filter;
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
