#include "hair/strand/measures.h"

#include <algorithm>
#include <cmath>

#include "particles/system.h"

namespace hair {

double largest_stretch(const Strand& strand, particles::Input x) {
  double worst = 0;
  for (int i = 0; i < strand.segments(); ++i) {
    const Eigen::Vector3d along = x.segment<3>(3 * i + 3) - x.segment<3>(3 * i);
    const double stretch = std::abs(along.norm() / strand.rest_length[i] - 1);
    if (std::isnan(stretch)) return stretch;
    worst = std::max(worst, stretch);
  }
  return worst;
}

double largest_stretch_rate(const Strand& strand, particles::Input x, particles::Input v) {
  double largest = 0;
  for (int i = 0; i < strand.segments(); ++i) {
    const Eigen::Vector3d e = x.segment<3>(3 * i + 3) - x.segment<3>(3 * i);
    const double length = e.norm();
    if (length == 0) continue;
    const double along = e.dot(v.segment<3>(3 * i + 3) - v.segment<3>(3 * i)) / length;
    const double rate = std::abs(along) / strand.rest_length[i];
    if (!(rate <= largest)) largest = rate;
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
