#include "hair/render/scene_bounds.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace hair {
namespace {

using particles::State;

constexpr int kBetweenKeys = 8;  // poses that are looked at from one key to the next

void add_ball(Bounds& bounds, const Vector3d& centre, double radius) {
  bounds.add(centre.array() - radius);
  bounds.add(centre.array() + radius);
}

// Around a circle: along each axis it reaches as far as the axis leaves its normal.
void add_circle(Bounds& bounds, const particles::Wire& wire) {
  const Vector3d reach = wire.radius * (1 - wire.normal.array().square()).max(0).sqrt();
  bounds.add(wire.centre - reach);
  bounds.add(wire.centre + reach);
}

// Above all planes.
Vector3d above(const std::vector<Obstacle>& obstacles, Vector3d point) {
  for (const Obstacle& obstacle : obstacles) {
    if (const auto* const plane = std::get_if<Plane>(&obstacle.shape)) {
      point -= std::min(plane->normal.dot(point - plane->point), 0.0) * plane->normal;
    }
  }
  return point;
}

// The other side of what swings from `pivot` under gravity.
Vector3d mirrored(const Vector3d& point, const Vector3d& pivot, const Vector3d& gravity) {
  const Vector3d arm = point - pivot, down = gravity.stableNormalized();
  return pivot + 2 * arm.dot(down) * down - arm;
}

// What hangs or swings from `pivot` and starts at `point`.
void add_swing(Bounds& bounds, const Vector3d& point, const Vector3d& pivot, const Vector3d& gravity) {
  bounds.add(point);
  if (gravity.norm() == 0) return;
  bounds.add(pivot + (point - pivot).norm() * gravity.stableNormalized());
  bounds.add(mirrored(point, pivot, gravity));
}

// A strand whose root is carried by `carry`.
template <class Carry>
void add_strand(Bounds& bounds, const Description& hair, const StrandStart& start, const Carry& carry) {
  const Vector3d root = start.state.x.head<3>();
  const Vector3d carried = carry(root);
  double reach = 0;
  for (int i = 0; i < start.strand.count(); ++i) {
    const Vector3d point = start.state.x.segment<3>(3 * i);
    reach = std::max(reach, (point - root).norm());
    bounds.add(carry(point));
  }
  if (hair.gravity.norm() > 0) {
    bounds.add(above(hair.obstacles, carried + reach * hair.gravity.stableNormalized()));
  }
  if (hair.drag > 0 && hair.wind.norm() > 0) {
    bounds.add(above(hair.obstacles, carried + reach * hair.wind.stableNormalized()));
  }
}

template <class Carry>
void add_obstacle(Bounds& bounds, const Obstacle& obstacle, const Carry& carry) {
  if (const auto* const ball = std::get_if<Sphere>(&obstacle.shape)) {
    add_ball(bounds, carry(ball->centre), ball->radius);
  } else if (const auto* const limb = std::get_if<Capsule>(&obstacle.shape)) {
    add_ball(bounds, carry(limb->a), limb->radius);
    add_ball(bounds, carry(limb->b), limb->radius);
  }
}

void add_rider(Bounds& bounds, const Description& hair, const Rider& rider) {
  const std::vector<Key>& keys = rider.motion.keys;
  const Pose first = keys.front().pose;
  for (std::size_t k = 0; k + 1 < keys.size(); ++k) {
    for (int i = 0; i <= kBetweenKeys; ++i) {
      const double part = static_cast<double>(i) / kBetweenKeys;
      const Pose pose = rider.motion.at((1 - part) * keys[k].time + part * keys[k + 1].time);
      const auto carry = [&](const Vector3d& x) -> Vector3d {
        return pose.rotation * (first.rotation.conjugate() * (x - first.position)) + pose.position;
      };
      for (const int strand : rider.strands) add_strand(bounds, hair, hair.strands[strand], carry);
      for (const int obstacle : rider.obstacles) add_obstacle(bounds, hair.obstacles[obstacle], carry);
    }
  }
}

// Whatever holds a toy's particles: those that are pinned, and wires.
std::optional<Vector3d> nearest_pin(const Toy& toy, const Vector3d& point) {
  std::optional<Vector3d> nearest;
  for (int i = 0; i < toy.particles.count(); ++i) {
    if (!toy.particles.is_pinned(i)) continue;
    const Vector3d pin = toy.start.x.segment<3>(3 * i);
    if (!nearest || (pin - point).norm() < (*nearest - point).norm()) nearest = pin;
  }
  return nearest;
}

void add_toy(Bounds& bounds, const Toy& toy, double seconds) {
  const int n = toy.particles.count();
  for (const particles::Wire& wire : toy.constraints.wires) add_circle(bounds, wire);
  const bool held = std::any_of(toy.particles.pinned.begin(), toy.particles.pinned.end(),
                                [](char pin) { return pin != 0; });
  for (int i = 0; i < n; ++i) {
    const Vector3d point = toy.start.x.segment<3>(3 * i);
    bounds.add(point);
    if (const auto pin = nearest_pin(toy, point)) add_swing(bounds, point, *pin, toy.gravity);
  }
  if (held || !toy.constraints.wires.empty()) return;
  Vector3d velocity = Vector3d::Zero();
  for (int i = 0; i < n; ++i)
    velocity += toy.particles.mass[i] / toy.particles.mass.sum() * toy.start.v.segment<3>(3 * i);
  for (int part = 1; part <= 16; ++part) {
    const double t = seconds * part / 16;
    const Vector3d way = t * velocity + t * t / 2 * toy.gravity;
    for (int i = 0; i < n; ++i) bounds.add(toy.start.x.segment<3>(3 * i) + way);
  }
}

}  // namespace

Bounds scene_bounds(const Scene& scene) {
  Bounds bounds;
  const auto stay = [](const Vector3d& x) { return x; };
  for (const StrandStart& start : scene.hair.strands) add_strand(bounds, scene.hair, start, stay);
  for (const Obstacle& obstacle : scene.hair.obstacles) add_obstacle(bounds, obstacle, stay);
  for (const Rider& rider : scene.riders) add_rider(bounds, scene.hair, rider);
  for (const Toy& toy : scene.toys) add_toy(bounds, toy, scene.frames / scene.frames_per_second);
  return bounds;
}

}  // namespace hair
