// STAFF ONLY. Every strand of a head, simulated: the interface of the fast engine, which reference/engine
// implements. It does the physics of H1, H2, H4 and H5, many strands at a time, with a direct solve
// instead of ConjGrad.
//
// A strand has n >= 2 points with equal distances l0 at rest, is straight at rest, and has the masses of a
// uniform strand: lambda l0 for each point (lambda the line density), half of that at the tip. The head holds
// its root. A strand of a groom whose segments differ in length is resampled first (hair/groom/resample.h).
//
// A step of h seconds, with x, v the state before it, and v0 = (root's new place - x_0) / h:
//
//   1. forces at x, v: stretch (H1), bending (H2), gravity, drag f = -drag m (v - wind)
//   2. (M - h df/dv - h^2 df/dx) dv = h (f + h df/dx v): H4 with the filtered geometric term and the definite
//      bending product. The root's velocity is v0, before and after. The unknown is y = v + dv - v0:
//
//        (M - h df/dv - h^2 df/dx) y = M (v - v0) + h (f - df/dv (v - v0)),   y_0 = 0,
//
//      since df/dx does not change if all points move alike (the clamp's tangent is that at the step's end)
//   3. x1 = x + h (v0 + y), x1_0 = the root's new place
//   4. x~ = x1 with its lengths corrected: H5's Newton method, to kLengthTolerance
//   5. impulse: v~ = v1 + (x~ - x1) / h, which is (x~ - x) / h
//   6. points inside of the head are pushed out as in obstacles.h, in the head's axes. A grid stores the
//      head's distances as integers of 16 bits (the largest stands for all larger ones), and a point rests
//      within kContactDepth. A point that went through the head in one step is not found.
//
// Without bending, correction or a head, the compiled loops leave out their terms.
//
// Strands do not touch each other. Neighbours on the head should follow each other in the list: they are then
// stepped side by side, and meet the head together. The result of a strand depends neither on the other
// strands nor on the number of threads, to the last bit. It differs in rounding between instruction sets.
// With one set it also differs between makers of processors, as their approximate reciprocals do (AVX-512
// uses these everywhere, AVX2 in contact with the head, scalar code nowhere).
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <span>

#include "hair/obstacles/solid.h"
#include "hair/strand/material.h"
#include "particles/gravity.h"
#include "particles/vectors.h"

namespace hair {

struct FullHeadSettings {
  Material material = {};
  Vector3d gravity = Vector3d(0, 0, -particles::kEarthGravity);  // m/s^2
  double drag = 0;                                               // 1/s, >= 0: N s/m for each kg of hair
  Vector3d wind = Vector3d::Zero();                              // m/s
  bool bending = true;
  bool clamped = true;  // with bending: hair leaves the head along root_tangent
  bool correct_lengths = true;
  std::shared_ptr<const Solid> head = nullptr;  // at most 1 m wide; null: there is no head
  double friction = 0;                          // Coulomb's mu between hair and head, >= 0
  double grid_spacing = 5e-3;                   // m, between the stored distances of the head
  int threads = 1;
};

// m, a fiftieth of a hair's radius. A last push shorter than ten times this is not checked: if the slopes of
// a grid's cells differ by more than a tenth, a point may stay a little deeper for a step.
inline constexpr double kContactDepth = 1e-6;

class FullHead {
 public:
  // points[k]: the points of strand k, 2 to kMostStrandPoints. Throws std::invalid_argument for settings
  // out of bounds.
  FullHead(std::span<const int> points, const FullHeadSettings& settings);
  ~FullHead();
  FullHead(const FullHead&) = delete;
  FullHead& operator=(const FullHead&) = delete;

  static constexpr int kMostStrandPoints = 10'000;

  int strands() const;
  std::int64_t particles() const;

  // Sets strand k in the head's axes, which are the world's until the first step: l0 (m, > 0), the
  // direction of its root (length 1), x and v (3n, m and m/s). Each strand needs this call before the first
  // step. Throws std::invalid_argument.
  void set_strand(int k, double rest_length, const Vector3d& root_tangent, particles::Input x,
                  particles::Input v);

  // One step of h seconds, h > 0, in which the head turns and moves from its last pose to `pose`. The first
  // step starts at the identity. Allocates nothing.
  void step(double h, const Eigen::Isometry3d& pose = Eigen::Isometry3d::Identity());

  // The state of strand k, 3n numbers each.
  void get_strand(int k, particles::Output x, particles::Output v) const;

  // The step, counted from 1, at whose end strand k had a number that is not finite, or a matrix that was not
  // positive definite; 0 if there is none. Such a strand stays as it is; other strands are not affected.
  std::int64_t broke_at(int k) const;
  int broken() const;  // strands that broke

  // The memory of the state and of the threads, in bytes.
  std::size_t bytes() const;

 private:
  struct Engine;
  std::unique_ptr<Engine> engine_;
};

}  // namespace hair
