// STAFF ONLY. Every strand of a head, simulated: the interface of the fast engine, which reference/engine
// implements. It does the physics of H1, H2, H4 and H5, many strands at a time, with a direct solve instead
// of ConjGrad.
//
// A strand has n >= 2 points with equal distances l0 at rest, is straight at rest, and has the masses of a
// uniform strand: lambda l0 of each point (lambda the line density), half of that at the tip. Its root is
// held by the head. A strand of a groom whose segments differ in length is resampled first
// (hair/head/resample.h).
//
// A step of h seconds, with x, v the state before it, and v0 = (root's new place - x_0) / h:
//
//   1. forces at x, v: stretch (H1), bending (H2), gravity, drag f = -drag m (v - wind)
//   2. (M - h df/dv - h^2 df/dx) dv = h (f + h df/dx v): H4 with the filtered geometric term and the definite bending
//      product. The root's velocity is v0, before and after. It is solved for y = v + dv - v0, which satisfies
//
//        (M - h df/dv - h^2 df/dx) y = M (v - v0) + h (f - df/dv (v - v0)),   y_0 = 0,
//
//      since df/dx does not change where all points move alike (the clamp's tangent is that at the step's end)
//   3. x1 = x + h (v0 + y), x1_0 = the root's new place
//   4. x~ = x1 with its lengths corrected: H5's Newton method, to kLengthTolerance
//   5. impulse: v~ = v1 + (x~ - x1) / h, which is (x~ - x) / h
//   6. points inside of the head are pushed out, as by obstacles.h, in the head's axes; of the head's surface one knows
//      its distances on a grid, as integers of 16 bits (the largest is the largest distance), and a point rests within
//      kContactDepth. A point that went through the head in one step
//      is not found.
//
// Without bending, correction or a head, what belongs to it is left out of the compiled loops.
//
// Strands do not touch each other. Those that are neighbours on the head should follow each other: they are
// then stepped side by side, and meet the head together. The result of a strand depends neither on the other
// strands nor on the number of threads, to the last bit. It differs in rounding between instruction sets; and
// of one set between makers of processors, as their approximate reciprocals do (AVX-512 takes these
// everywhere, AVX2 in contact with the head, scalars nowhere).
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <span>

#include "hair/strand/material.h"
#include "hair/strand/solid.h"
#include "particles/gravity.h"
#include "particles/vectors.h"

namespace hair {

struct FullHeadSettings {
  Material material = {};
  Vector3d gravity = Vector3d(0, 0, -particles::kEarthGravity);  // m/s^2
  double drag = 0;                                               // 1/s, >= 0: N s/m of each kg of hair
  Vector3d wind = Vector3d::Zero();                              // m/s
  bool bending = true;
  bool clamped = true;  // with bending: hair leaves the head along root_tangent
  bool correct_lengths = true;
  std::shared_ptr<const Solid> head = nullptr;  // at most 1 m wide; null: nothing is in the way
  double friction = 0;                          // of the head, Coulomb's mu, >= 0
  double grid_spacing = 5e-3;                   // m, of the head's distances
  int threads = 1;
};

// m, a fiftieth of a hair's radius. A last push shorter than ten times this is not checked: where a grid's
// cells differ in slope by more than a tenth, a point may stay a little deeper for a step.
inline constexpr double kContactDepth = 1e-6;

class FullHead {
 public:
  // points[k]: of strand k, 2 to kMostStrandPoints. Throws std::invalid_argument for settings out of bounds.
  FullHead(std::span<const int> points, const FullHeadSettings& settings);
  ~FullHead();
  FullHead(const FullHead&) = delete;
  FullHead& operator=(const FullHead&) = delete;

  static constexpr int kMostStrandPoints = 10'000;

  int strands() const;
  std::int64_t particles() const;

  // Strand k in the head's axes, which are the world's until the first step: l0 (m, > 0), the direction of
  // its root (of length 1), x and v (3n, m and m/s). Before the first step this is due for each strand.
  // Throws std::invalid_argument.
  void set_strand(int k, double rest_length, const Vector3d& root_tangent, particles::Input x,
                  particles::Input v);

  // One step of h seconds, h > 0, at whose end the head is at `pose`: it turns and moves from where it was to
  // there. The first step starts at the identity. Allocates nothing.
  void step(double h, const Eigen::Isometry3d& pose = Eigen::Isometry3d::Identity());

  // The state of strand k, 3n numbers each.
  void get_strand(int k, particles::Output x, particles::Output v) const;

  // The step, counted from 1, at whose end strand k had a number that is not finite, or whose matrix was not
  // positive definite; 0: none. Such a strand stays as it is; others do not notice.
  std::int64_t broke_at(int k) const;
  int broken() const;  // strands that broke

  // Bytes that the state and the threads' memory take.
  std::size_t bytes() const;

 private:
  struct Engine;
  std::unique_ptr<Engine> engine_;
};

}  // namespace hair
