#include "hair/measures.h"

#include <cmath>

#include "particles/system.h"

namespace hair {

double largest_stretch(const Strand& strand, particles::Input x) {
  double largest = 0;
  for (int i = 0; i < strand.segments(); ++i) {
    const double length = (x.segment<3>(3 * i + 3) - x.segment<3>(3 * i)).norm();
    const double stretch = std::abs(length / strand.rest_length[i] - 1);
    if (!(stretch <= largest)) largest = stretch;
    if (std::isnan(largest)) break;
  }
  return largest;
}

Measures measure(const Strand& strand, const particles::Particles& particles, const particles::Force& force,
                 const particles::State& state) {
  Measures measures;
  measures.stretch = largest_stretch(strand, state.x);
  measures.kinetic = particles::kinetic_energy(particles, state.v);
  measures.potential = force.energy(state.x);
  measures.momentum = particles::momentum(particles, state.v);
  measures.angular_momentum = particles::angular_momentum(particles, state.x, state.v, state.x.head<3>());
  return measures;
}

}  // namespace hair
