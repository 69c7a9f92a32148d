// What hair can't go through: the ground, a head, a limb. Collisions are a stage of their own after a step,
// which pushes particles out, takes away the velocity that they hit with, and lets the surface rub. Sources:
// R. Bridson, R. Fedkiw and J. Anderson, "Robust Treatment of Collisions, Contact and Friction for Cloth
// Animation" (SIGGRAPH 2002), for velocities; M. Macklin et al., "Unified Particle Physics for Real-Time
// Applications" (SIGGRAPH 2014), for positions.
//
// Only particles collide, not the segments between them: with segments of length l a sphere of radius r shows
// through the hair by l^2 / 8r, and what is smaller than a segment may slip between two particles.
#pragma once

#include <variant>
#include <vector>

#include "particles/state.h"

namespace hair {

using Eigen::Vector3d;

// All that is below: on the side of `point` that the normal (of length 1) points away from.
struct Plane {
  Vector3d point, normal;  // m, 1
};

struct Sphere {
  Vector3d centre;  // m
  double radius;    // m, > 0
};

// All points that are at most `radius` from the line from a to b. a may be b.
struct Capsule {
  Vector3d a, b;  // m
  double radius;  // m, > 0
};

struct Obstacle {
  std::variant<Plane, Sphere, Capsule> shape;
  double friction = 0;                   // Coulomb's mu, >= 0: the friction is at most mu times the pressure
  Vector3d velocity = Vector3d::Zero();  // m/s: what moves, rubs along
};

struct Surface {
  double distance;  // m, of a point to the obstacle's surface; inside it is negative
  Vector3d normal;  // from the obstacle to the point, of length 1
};

// A point that is as near to one side as to another, such as a sphere's centre, gets one of the normals.
Surface surface_at(const Obstacle& obstacle, const Vector3d& point);

// Throws std::invalid_argument for a radius or friction that is out of bounds, a normal that is not of length
// 1, or what is not finite.
void check_obstacle(const Obstacle& obstacle);

// The obstacle moves for h seconds.
void move_obstacle(Obstacle& obstacle, double h);

struct CollisionReport {
  int contacts = 0;        // particles that were inside an obstacle
  double deepest = 0;      // m, how deep the deepest of them was
  double penetration = 0;  // m, the deepest that is left: > 0 only where obstacles leave no room between them
};

// Of each particle that is not pinned and is inside an obstacle, with n the normal there and u its velocity
// relative to the obstacle:
//
//   x += depth n, and its way along the surface since x_before (relative to the obstacle, h seconds) gets shorter
//        by at most mu depth;
//   u -= (u . n) n if u . n < 0, and its part along the surface gets shorter by at most mu |u . n|.
//
// So a particle rests on a slope if its tangent is at most mu, without creeping, and slides down a steeper
// one with the acceleration g (sin - mu cos). Obstacles are dealt with one after the other, again until no
// particle is inside one by more than rounding, at most kMostCollisionPasses times.
inline constexpr int kMostCollisionPasses = 200;

CollisionReport collide(const std::vector<Obstacle>& obstacles, const particles::Particles& particles,
                        double h, particles::Input x_before, particles::State& state);

}  // namespace hair
