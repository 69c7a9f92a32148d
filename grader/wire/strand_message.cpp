// STAFF ONLY.
#include "grader/wire/strand_message.h"

namespace grader {

void put(MessageWriter& message, const Eigen::VectorXd& vector) {
  message.put(std::span<const double>(vector.data(), static_cast<std::size_t>(vector.size())));
}

Eigen::VectorXd get_vector(MessageReader& message, Eigen::Index expected) {
  const std::vector<double> values = message.get_doubles(static_cast<std::size_t>(expected));
  return Eigen::Map<const Eigen::VectorXd>(values.data(), expected);
}

void put(MessageWriter& message, const hair::Strand& strand) {
  put(message, strand.mass);
  put(message, strand.rest_length);
  message.put(strand.stretch_rigidity).put(strand.bend_rigidity).put(strand.skip_rigidity);
  message.put(static_cast<std::uint8_t>(strand.clamped));
  for (double component : strand.root_tangent) message.put(component);
}

hair::Strand get_strand(MessageReader& message) {
  const std::vector<double> mass = message.get_doubles();
  if (mass.empty()) throw MalformedMessage("a strand without particles");
  hair::Strand strand;
  strand.mass = Eigen::Map<const Eigen::VectorXd>(mass.data(), static_cast<Eigen::Index>(mass.size()));
  strand.rest_length = get_vector(message, strand.mass.size() - 1);
  strand.stretch_rigidity = message.get<double>();
  strand.bend_rigidity = message.get<double>();
  strand.skip_rigidity = message.get<double>();
  strand.clamped = message.get<std::uint8_t>() != 0;
  for (double& component : strand.root_tangent) component = message.get<double>();
  return strand;
}

}  // namespace grader
