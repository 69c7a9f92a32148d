// STAFF ONLY. Particles and their state in a message.
#pragma once

#include "grader/wire/strand_message.h"
#include "particles/state.h"

namespace grader {

inline void put(MessageWriter& message, const particles::Particles& particles) {
  put(message, particles.mass);
  Eigen::VectorXd pinned(particles.count());
  for (int i = 0; i < particles.count(); ++i) pinned[i] = particles.is_pinned(i) ? 1 : 0;
  put(message, pinned);
}

inline particles::Particles get_particles(MessageReader& message) {
  const std::vector<double> mass = message.get_doubles();
  const std::vector<double> pinned = message.get_doubles(mass.size());
  particles::Particles particles;
  particles.mass = Eigen::Map<const Eigen::VectorXd>(mass.data(), static_cast<Eigen::Index>(mass.size()));
  for (const double value : pinned) particles.pinned.push_back(value != 0);
  return particles;
}

inline void put(MessageWriter& message, const particles::State& state) {
  put(message, state.x);
  put(message, state.v);
}

// Of n particles; MalformedMessage for another length.
inline particles::State get_state(MessageReader& message, int n) {
  particles::State state;
  state.x = get_vector(message, Eigen::Index{3} * n);
  state.v = get_vector(message, Eigen::Index{3} * n);
  return state;
}

}  // namespace grader
