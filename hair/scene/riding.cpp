#include "hair/scene/riding.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "particles/require.h"

namespace hair {

using particles::require, particles::require_finite;

namespace {

Vector3d angular_velocity(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to, double h) {
  const Eigen::AngleAxisd turn(to * from.conjugate());
  return turn.angle() / h * turn.axis();
}

struct PlaceOf {
  Vector3d operator()(const Plane& plane) const { return plane.point; }
  Vector3d operator()(const Sphere& sphere) const { return sphere.centre; }
  Vector3d operator()(const Capsule& capsule) const { return capsule.a; }
  Vector3d operator()(const PlacedSolid& placed) const { return placed.at; }
};

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
  return std::visit(PlaceOf(), obstacle.shape);
}

Riding::LedRoot Riding::root_of(const Description& hair, int strand) {
  const auto index = static_cast<std::size_t>(strand);
  if (index >= hair.strands.size()) {
    const RestShape shape = root_of_curve(hair.modelled[index - hair.strands.size()].spec);
    return {strand, shape.x.head<3>(), shape.tangent, shape.normal};
  }
  const StrandStart& start = hair.strands[index];
  const Vector3d& tangent = start.strand.root_tangent;
  // A strand that is straight at rest may have any normal.
  const bool fits = std::abs(tangent.dot(start.root_normal)) <= 1e-6;
  return {strand, start.state.x.head<3>(), tangent, fits ? start.root_normal : tangent.unitOrthogonal()};
}

Riding::Riding(const Rider& rider, const Description& hair) : motion_(rider.motion) {
  check(motion_);
  turns_ = turns(motion_);
  const auto check_index = [](const char* what, int index, std::size_t count) {
    require(index >= 0 && static_cast<std::size_t>(index) < count, what, index,
            "less than " + std::to_string(count));
  };
  for (const int i : rider.strands) {
    check_index("a rider's strand", i, hair.strands.size() + hair.modelled.size());
    roots_.push_back(root_of(hair, i));
  }
  for (const int i : rider.obstacles) {
    check_index("a rider's obstacle", i, hair.obstacles.size());
    const Obstacle& obstacle = hair.obstacles[i];
    const auto* const solid = std::get_if<PlacedSolid>(&obstacle.shape);
    if (turns_ && !solid && !std::holds_alternative<Sphere>(obstacle.shape))
      throw std::invalid_argument("obstacle " + std::to_string(i) +
                                  " rides on a motion that turns, which only a sphere and a solid can");
    obstacles_.push_back({i, place_of(obstacle), solid ? solid->rotation : Eigen::Quaterniond::Identity()});
  }
}

void Riding::lead(Simulation& simulation, double time, double h, const Way& held, const Way& hand) const {
  const Way way = hand * way_at(motion_, time + h);
  const bool turns = turns_ || hand.rotation.w() != 1 || held.rotation.w() != 1;
  const Vector3d spin = turns ? angular_velocity((held * way_at(motion_, time)).rotation, way.rotation, h)
                              : Vector3d(Vector3d::Zero());
  for (const LedRoot& root : roots_) {
    const Vector3d here = simulation.body(root.strand).root_position(), there = way(root.position);
    Root next{there, root.tangent, root.normal, (there - here) / h, Vector3d::Zero()};
    if (turns) {
      next.tangent = (way.rotation * root.tangent).normalized();
      next.normal = (way.rotation * root.normal).normalized();
      next.angular_velocity = spin;
    }
    simulation.set_root(root.strand, next);
  }
  for (const LedObstacle& led : obstacles_) {
    const Obstacle& obstacle = simulation.obstacles()[led.obstacle];
    simulation.set_obstacle_velocity(led.obstacle, (way(led.place) - place_of(obstacle)) / h);
    if (const auto* const solid = std::get_if<PlacedSolid>(&obstacle.shape); solid && turns)
      simulation.set_obstacle_spin(led.obstacle,
                                   angular_velocity(solid->rotation, way.rotation * led.rotation, h));
  }
}

}  // namespace hair
