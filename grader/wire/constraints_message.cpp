// STAFF ONLY.
#include "grader/wire/constraints_message.h"

namespace grader {
namespace {

void put(MessageWriter& message, const Eigen::Vector3d& vector) {
  for (double component : vector) message.put(component);
}

Eigen::Vector3d get_point(MessageReader& message) {
  Eigen::Vector3d point;
  for (double& component : point) component = message.get<double>();
  return point;
}

}  // namespace

void put(MessageWriter& message, const particles::Constraints& constraints) {
  message.put(static_cast<int>(constraints.rods.size())).put(static_cast<int>(constraints.wires.size()));
  for (const particles::Rod& rod : constraints.rods) message.put(rod.i).put(rod.j).put(rod.length);
  for (const particles::Wire& wire : constraints.wires) {
    message.put(wire.i);
    put(message, wire.centre);
    put(message, wire.normal);
    message.put(wire.radius);
  }
  message.put(constraints.stiffness).put(constraints.damping);
}

particles::Constraints get_constraints(MessageReader& message) {
  particles::Constraints constraints;
  const int rods = message.get<int>(), wires = message.get<int>();
  for (int k = 0; k < rods; ++k) {
    const int i = message.get<int>(), j = message.get<int>();
    constraints.rods.push_back({i, j, message.get<double>()});
  }
  for (int k = 0; k < wires; ++k) {
    particles::Wire wire;
    wire.i = message.get<int>();
    wire.centre = get_point(message);
    wire.normal = get_point(message);
    wire.radius = message.get<double>();
    constraints.wires.push_back(wire);
  }
  constraints.stiffness = message.get<double>();
  constraints.damping = message.get<double>();
  return constraints;
}

}  // namespace grader
