// STAFF ONLY.
#include "grader/wire/particles_message.h"

#include "grader/wire/strand_message.h"

namespace grader {

void put(MessageWriter& message, const particles::Particles& particles) {
  put(message, particles.mass);
  for (int i = 0; i < particles.count(); ++i)
    message.put(static_cast<std::uint8_t>(particles.is_pinned(i) ? 1 : 0));
}

particles::Particles get_particles(MessageReader& message) {
  const std::vector<double> mass = message.get_doubles();
  particles::Particles particles;
  particles.mass = Eigen::Map<const Eigen::VectorXd>(mass.data(), static_cast<Eigen::Index>(mass.size()));
  for (std::size_t i = 0; i < mass.size(); ++i)
    particles.pinned.push_back(message.get<std::uint8_t>() != 0 ? 1 : 0);
  return particles;
}

void put(MessageWriter& message, const particles::State& state) {
  put(message, state.x);
  put(message, state.v);
}

particles::State get_state(MessageReader& message, int n) {
  particles::State state;
  state.x = get_vector(message, Eigen::Index{3} * n);
  state.v = get_vector(message, Eigen::Index{3} * n);
  return state;
}

}  // namespace grader
