#include "hair/scene/riding.h"

#include <stdexcept>
#include <string>

#include "particles/require.h"

namespace hair {

using particles::require, particles::require_finite;

namespace {

Vector3d place(const Plane& plane) {
  return plane.point;
}

Vector3d place(const Sphere& sphere) {
  return sphere.centre;
}

Vector3d place(const Capsule& capsule) {
  return capsule.a;
}

void check(const Motion& motion) {
  if (motion.keys.empty()) throw std::invalid_argument("a motion without keys; give one at least");
  for (std::size_t k = 0; k < motion.keys.size(); ++k) {
    const Key& key = motion.keys[k];
    require_finite("a key's time", key.time);
    for (double value : key.pose.position) require_finite("a key's position", value);
    const double norm = key.pose.rotation.norm();
    require(norm >= 1 - 1e-9 && norm <= 1 + 1e-9, "the length of a key's rotation", norm, "1");
    if (k > 0)
      require(key.time > motion.keys[k - 1].time, "the time of key " + std::to_string(k), key.time,
              "later than that of the key before it");
  }
}

}  // namespace

Vector3d place_of(const Obstacle& obstacle) {
  return std::visit([](const auto& shape) { return place(shape); }, obstacle.shape);
}

Riding::Riding(const Rider& rider, const Description& hair) : motion_(rider.motion) {
  check(motion_);
  turns_ = turns(motion_);
  const auto check_index = [](const char* what, int index, std::size_t count) {
    require(index >= 0 && static_cast<std::size_t>(index) < count, what, index,
            "less than " + std::to_string(count));
  };
  for (const int i : rider.strands) {
    check_index("a rider's strand", i, hair.strands.size());
    const StrandStart& start = hair.strands[i];
    roots_.push_back(
        {i, start.strand.clamped, start.state.x.head<3>(), start.strand.root_tangent, start.root_normal});
  }
  for (const int i : rider.obstacles) {
    check_index("a rider's obstacle", i, hair.obstacles.size());
    const Obstacle& obstacle = hair.obstacles[i];
    if (turns_ && !std::holds_alternative<Sphere>(obstacle.shape))
      throw std::invalid_argument("obstacle " + std::to_string(i) +
                                  " rides on a motion that turns, which only a sphere can");
    bodies_.push_back({i, place_of(obstacle)});
  }
}

void Riding::lead(Simulation& simulation, double time, double h) const {
  const Way way = way_at(motion_, time + h);
  for (const Root& root : roots_) {
    const Vector3d here = simulation.state(root.strand).x.head<3>();
    simulation.set_root_velocity(root.strand, (way(root.position) - here) / h);
    if (turns_ && root.clamped)
      simulation.set_root_frame(root.strand, (way.rotation * root.tangent).normalized(),
                                (way.rotation * root.normal).normalized());
  }
  for (const Body& body : bodies_)
    simulation.set_obstacle_velocity(body.obstacle,
                                     (way(body.place) - place_of(simulation.obstacles()[body.obstacle])) / h);
}

}  // namespace hair
