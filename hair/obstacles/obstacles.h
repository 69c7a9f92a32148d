// Obstacles that hair can't pass: the ground, a head, a limb. Collisions are a separate stage after a step.
// It pushes particles out, removes the velocity into the obstacle, and applies friction. Sources: R. Bridson,
// R. Fedkiw and J. Anderson, "Robust Treatment of Collisions, Contact and Friction for Cloth Animation"
// (SIGGRAPH 2002), for velocities; M. Macklin et al., "Unified Particle Physics for Real-Time Applications"
// (SIGGRAPH 2014), for positions.
//
// Only particles collide, not the segments between them: with segments of length l a sphere of radius r
// sticks out of the hair by l^2 / 8r, and an obstacle smaller than a segment may slip between two particles.
// A particle collides along its path, which is straight during a step in the frame of the moving obstacle, so
// even a fast particle can't pass through.
#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "hair/obstacles/solid.h"
#include "particles/state.h"

namespace hair {

// The half-space on the side of `point` opposite to the normal (of length 1).
struct Plane {
  Vector3d point, normal;  // m, 1
};

struct Sphere {
  Vector3d centre;  // m
  double radius;    // m, > 0
};

// All points within `radius` of the line segment from a to b. a may equal b.
struct Capsule {
  Vector3d a, b;  // m
  double radius;  // m, > 0
};

// A solid that is turned about its origin, and then moved by `at`.
struct PlacedSolid {
  std::shared_ptr<const Solid> solid;
  Vector3d at = Vector3d::Zero();                                // m
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  // length 1
  Vector3d angular_velocity = Vector3d::Zero();                  // rad/s, about `at`
};

struct Obstacle {
  std::variant<Plane, Sphere, Capsule, PlacedSolid> shape;
  double friction = 0;                   // Coulomb's mu, >= 0: the friction is at most mu times the pressure
  Vector3d velocity = Vector3d::Zero();  // m/s, of a placed solid's `at`: the friction drags hair along
};

// A point with equal distances to several sides, such as a sphere's centre, gets one of the normals.
Surface surface_at(const Obstacle& obstacle, const Vector3d& point);

// The velocity of the obstacle at a point.
Vector3d velocity_at(const Obstacle& obstacle, const Vector3d& point);

// Throws std::invalid_argument for no solid, for a radius or friction out of bounds, a normal or rotation
// that is not of length 1, and values that are not finite.
void check_obstacle(const Obstacle& obstacle);

// Moves the obstacle for h seconds.
void move_obstacle(Obstacle& obstacle, double h);

struct CollisionReport {
  int contacts = 0;        // particles that were inside an obstacle
  double deepest = 0;      // m, the depth of the deepest one
  double penetration = 0;  // m, the largest remaining depth: > 0 only if obstacles leave no room between them
  double work = 0;         // J: impulses times the velocities of the obstacles that gave them
  Vector3d impulse = Vector3d::Zero();  // N s, their sum
};

// A step changes each particle that is not pinned and is inside an obstacle. With n the normal there and u
// its velocity relative to the obstacle:
//
//   x += depth n, and its displacement along the surface since x_before (relative to the obstacle, during h
//        seconds) gets shorter by at most mu depth;
//   u -= (u . n) n if u . n < 0, and its component along the surface gets shorter by at most mu |u . n|.
//
// A particle that goes through an obstacle, and ends outside or nearer to another side, meets the plane that
// touches the obstacle at the entry: depth and n are that plane's. A sliding particle may cut off up to 60
// degrees of the surface. A particle that is inside at the start is pushed out to the nearest side.
//
// So a particle rests on a slope whose tangent is at most mu, without creeping, and slides down a steeper one
// with the acceleration g (sin - mu cos). Obstacles are handled one after the other, repeatedly, until no
// particle is inside one by more than rounding, at most kMostCollisionPasses times.
inline constexpr int kMostCollisionPasses = 200;

CollisionReport collide(const std::vector<Obstacle>& obstacles, const particles::Particles& particles,
                        double h, particles::Input x_before, particles::State& state);

}  // namespace hair
