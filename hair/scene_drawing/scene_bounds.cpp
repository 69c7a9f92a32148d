#include "hair/scene_drawing/scene_bounds.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "hair/head/surface_net.h"

namespace hair {
namespace {

constexpr double kTorn = 1.2;    // relative to the hair's length
constexpr int kBetweenKeys = 8;  // poses between two keys

void add_ball(Bounds& bounds, const Vector3d& centre, double radius) {
  bounds.extend(Bounds(centre.array() - radius, centre.array() + radius));
}

// Adds the points at most `reach` from a circle. Along each axis the circle's extent depends on the axis'
// angle to the normal.
void add_circle(Bounds& bounds, const Vector3d& centre, const Vector3d& normal, double radius, double reach) {
  const Vector3d half = radius * (1 - normal.array().square()).max(0).sqrt() + reach;
  bounds.extend(centre - half);
  bounds.extend(centre + half);
}

// Moves a point above all planes.
Vector3d above(const std::vector<Obstacle>& obstacles, Vector3d point) {
  for (const Obstacle& obstacle : obstacles) {
    if (const auto* const plane = std::get_if<Plane>(&obstacle.shape)) {
      point -= std::min(plane->normal.dot(point - plane->point), 0.0) * plane->normal;
    }
  }
  return point;
}

// The mirrored point of a swing around `pivot` under gravity.
Vector3d mirrored(const Vector3d& point, const Vector3d& pivot, const Vector3d& gravity) {
  const Vector3d arm = point - pivot, down = gravity.stableNormalized();
  return pivot + 2 * arm.dot(down) * down - arm;
}

// Adds the swing of an object that starts at `point`, and hangs from `pivot` on a line of the length `reach`.
void add_swing(Bounds& bounds, const Vector3d& point, const Vector3d& pivot, double reach,
               const Vector3d& gravity) {
  bounds.extend(point);
  if (gravity.norm() == 0) return;
  bounds.extend(pivot + reach * gravity.stableNormalized());
  bounds.extend(mirrored(point, pivot, gravity));
}

// The largest distance of a strand from its root: its whole length, unless it rests in curls.
double reach_of(const StrandStart& start) {
  if (start.rest_curvature.size() == 0) return start.strand.rest_length.sum();
  double reach = 0;
  for (int i = 0; i < start.strand.count(); ++i) {
    reach = std::max(reach, (start.state.x.segment<3>(3 * i) - start.state.x.head<3>()).norm());
  }
  return reach;
}

// A particle that is too fast for its weight circles on its arm.
void add_orbit(Bounds& bounds, const Vector3d& arm, const Vector3d& velocity, const Vector3d& pivot,
               const Vector3d& gravity) {
  const Vector3d normal = arm.cross(velocity);
  if (normal.norm() == 0 || velocity.squaredNorm() <= 4 * gravity.norm() * arm.norm()) return;
  add_circle(bounds, pivot, normal.normalized(), arm.norm(), 0);
}

// A strand whose root is moved by `carry`.
void add_strand(Bounds& bounds, const Description& hair, const StrandStart& start, const Way& carry) {
  const Vector3d root = carry(Vector3d(start.state.x.head<3>()));
  const double reach = reach_of(start);
  Bounds swing;
  for (int i = 0; i < start.strand.count(); ++i) {
    const Vector3d at = carry(Vector3d(start.state.x.segment<3>(3 * i)));
    add_swing(swing, at, root, reach, hair.gravity);
    // Hair that starts torn flies to the other side of its root.
    if ((at - root).norm() > kTorn * reach) swing.extend(root - reach * (at - root).normalized());
    add_orbit(swing, at - root, start.state.v.segment<3>(3 * i) - start.state.v.head<3>(), root,
              hair.gravity);
  }
  if (hair.drag > 0 && hair.wind.norm() > 0) swing.extend(root + reach * hair.wind.stableNormalized());
  bounds.extend(above(hair.obstacles, swing.min()));
  bounds.extend(above(hair.obstacles, swing.max()));
}

// A strand of any model starts like one of masses and springs. `made` holds that of another model.
const StrandStart& start_of(const Description& hair, std::size_t strand, StrandStart& made) {
  if (strand < hair.strands.size()) return hair.strands[strand];
  return made = discretise(finely_divided(hair.modelled[strand - hair.strands.size()].spec));
}

void add_obstacle(Bounds& bounds, const Obstacle& obstacle, const Way& carry) {
  if (const auto* const ball = std::get_if<Sphere>(&obstacle.shape)) {
    add_ball(bounds, carry(ball->centre), ball->radius);
  } else if (const auto* const limb = std::get_if<Capsule>(&obstacle.shape)) {
    add_ball(bounds, carry(limb->a), limb->radius);
    add_ball(bounds, carry(limb->b), limb->radius);
  } else if (const auto* const placed = std::get_if<PlacedSolid>(&obstacle.shape)) {
    for (const Vector3d& corner : corners_of(placed->solid->box()))
      bounds.extend(carry(placed->at + placed->rotation * corner));
  }
}

void add_rider(Bounds& bounds, const Description& hair, const Rider& rider) {
  const std::vector<Key>& keys = rider.motion.keys;
  StrandStart made;
  for (std::size_t k = 0; k + 1 < keys.size(); ++k) {
    for (int i = 0; i <= kBetweenKeys; ++i) {
      const double part = static_cast<double>(i) / kBetweenKeys;
      const Way carry = way_at(rider.motion, (1 - part) * keys[k].time + part * keys[k + 1].time);
      for (const int strand : rider.strands)
        add_strand(bounds, hair, start_of(hair, static_cast<std::size_t>(strand), made), carry);
      for (const int obstacle : rider.obstacles) add_obstacle(bounds, hair.obstacles[obstacle], carry);
    }
  }
}

// The hold of a particle: the nearest one, along springs and rods, that is pinned or on a wire.
struct Hold {
  int by = -1;  // none
  double reach = std::numeric_limits<double>::infinity();
};

// E. W. Dijkstra, "A Note on Two Problems in Connexion with Graphs", 1959.
std::vector<Hold> holds_of(const Toy& toy) {
  const int n = toy.particles.count();
  std::vector<std::vector<std::pair<int, double>>> neighbours(n);
  const auto join = [&](int i, int j, double length) {
    neighbours[i].emplace_back(j, length);
    neighbours[j].emplace_back(i, length);
  };
  for (const particles::Spring& spring : toy.springs) join(spring.i, spring.j, spring.rest_length);
  for (const particles::Rod& rod : toy.constraints.rods) join(rod.i, rod.j, rod.length);

  std::vector<Hold> holds(n);
  std::set<std::pair<double, int>> waiting;
  const auto reach = [&](int i, const Hold& hold) {
    if (hold.reach >= holds[i].reach) return;
    waiting.erase({holds[i].reach, i});
    holds[i] = hold;
    waiting.insert({hold.reach, i});
  };
  for (int i = 0; i < n; ++i) {
    if (toy.particles.is_pinned(i)) reach(i, {i, 0});
  }
  for (const particles::Wire& wire : toy.constraints.wires) reach(wire.i, {wire.i, 0});
  while (!waiting.empty()) {
    const int i = waiting.begin()->second;
    waiting.erase(waiting.begin());
    for (const auto& [j, length] : neighbours[i]) reach(j, {holds[i].by, holds[i].reach + length});
  }
  return holds;
}

// Free particles fall.
void add_fall(Bounds& bounds, const Toy& toy, const std::vector<int>& free, double seconds) {
  double mass = 0;
  Vector3d momentum = Vector3d::Zero();
  for (const int i : free) {
    mass += toy.particles.mass[i];
    momentum += toy.particles.mass[i] * toy.start.v.segment<3>(3 * i);
  }
  for (int part = 0; part <= 16 && !free.empty(); ++part) {
    const double t = seconds * part / 16;
    const Vector3d way = t * momentum / mass + t * t / 2 * toy.gravity;
    for (const int i : free) bounds.extend(toy.start.x.segment<3>(3 * i) + way);
  }
}

void add_toy(Bounds& bounds, const Toy& toy, double seconds) {
  const int n = toy.particles.count();
  const std::vector<Hold> holds = holds_of(toy);
  std::vector<double> from_wires(n, 0);  // the length of everything that hangs on a particle
  std::vector<int> free;
  for (int i = 0; i < n; ++i) {
    const Vector3d point = toy.start.x.segment<3>(3 * i);
    const Hold& hold = holds[i];
    if (hold.by < 0) {
      free.push_back(i);
    } else {
      from_wires[hold.by] = std::max(from_wires[hold.by], hold.reach);
      add_swing(bounds, point, toy.start.x.segment<3>(3 * hold.by), hold.reach, toy.gravity);
    }
  }
  for (const particles::Wire& wire : toy.constraints.wires)
    add_circle(bounds, wire.centre, wire.normal, wire.radius, from_wires[wire.i]);
  add_fall(bounds, toy, free, seconds);
}

// Collects the points of an outline.
using Outline = std::vector<Vector3d>;

constexpr int kOutlineCells = 60;  // along a solid's longest side

void outline_strand(Outline& outline, const Description& hair, const StrandStart& start, const Way& carry) {
  const Vector3d root = carry(Vector3d(start.state.x.head<3>()));
  for (int i = 0; i < start.strand.count(); ++i)
    outline.push_back(above(hair.obstacles, carry(Vector3d(start.state.x.segment<3>(3 * i)))));
  const double reach = reach_of(start);
  if (hair.drag > 0 && hair.wind.norm() > 0)
    outline.push_back(above(hair.obstacles, root + reach * hair.wind.stableNormalized()));
  if (hair.gravity.norm() > 0)
    outline.push_back(above(hair.obstacles, root + reach * hair.gravity.stableNormalized()));
}

// Points of the obstacle's surface, or the corners of its box, at the start.
Outline outline_of(const Obstacle& obstacle) {
  Outline outline;
  if (const auto* const placed = std::get_if<PlacedSolid>(&obstacle.shape)) {
    for (const Vector3d& point : surface_net(*placed->solid, kOutlineCells).points)
      outline.push_back(placed->at + placed->rotation * point);
    return outline;
  }
  Bounds bounds;
  add_obstacle(bounds, obstacle, {});
  if (bounds.isEmpty()) return outline;
  const auto corners = corners_of(bounds);
  return {corners.begin(), corners.end()};
}

}  // namespace

Outline scene_outline(const Scene& scene) {
  Outline outline;
  StrandStart made;
  for (std::size_t i = 0; i < scene.hair.strands.size() + scene.hair.modelled.size(); ++i)
    outline_strand(outline, scene.hair, start_of(scene.hair, i, made), {});
  std::vector<Outline> obstacles;  // a surface is calculated once, not for each key
  for (const Obstacle& obstacle : scene.hair.obstacles) {
    obstacles.push_back(outline_of(obstacle));
    outline.insert(outline.end(), obstacles.back().begin(), obstacles.back().end());
  }
  for (const Rider& rider : scene.riders) {
    for (const Key& key : rider.motion.keys) {
      const Way carry = way_at(rider.motion, key.time);
      for (const int strand : rider.strands)
        outline_strand(outline, scene.hair, start_of(scene.hair, static_cast<std::size_t>(strand), made),
                       carry);
      for (const int obstacle : rider.obstacles)
        for (const Vector3d& point : obstacles[obstacle]) outline.push_back(carry(point));
    }
  }
  Bounds toys;
  for (const Toy& toy : scene.toys) add_toy(toys, toy, scene.frames / scene.frames_per_second);
  if (!toys.isEmpty())
    for (const Vector3d& corner : corners_of(toys)) outline.push_back(corner);
  return outline;
}

Bounds scene_bounds(const Scene& scene) {
  Bounds bounds;
  StrandStart made;
  for (std::size_t i = 0; i < scene.hair.strands.size() + scene.hair.modelled.size(); ++i)
    add_strand(bounds, scene.hair, start_of(scene.hair, i, made), {});
  for (const Obstacle& obstacle : scene.hair.obstacles) add_obstacle(bounds, obstacle, {});
  for (const Rider& rider : scene.riders) add_rider(bounds, scene.hair, rider);
  for (const Toy& toy : scene.toys) add_toy(bounds, toy, scene.frames / scene.frames_per_second);
  return bounds;
}

}  // namespace hair
