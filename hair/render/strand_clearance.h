// Keeps drawn strands out of solids. Guides stay outside of a head, but what is interpolated between them
// cuts corners, and so do clumps and fly-aways. What is inside moves along the distance's gradient to the
// surface, and a little beyond it; its neighbours go along, so that there is no kink, and lengths are
// restored as far as there is room. Roots stay, for they are on the scalp.
//
// It has no effect on the motion, and costs only strands that are near a solid: a coarse grid, made once,
// says where that is. Without obstacles nothing is looked at.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "hair/render/drawing.h"
#include "hair/simulation/strand_threads.h"
#include "hair/strand/obstacles.h"

namespace hair {

class StrandClearance {
 public:
  // How far from a surface strands are kept, m: each has a place of its own in this layer. Up to the first,
  // nearer to their roots.
  static constexpr double kLow = 0.0008, kHigh = 0.0025;

  // obstacles: those of which `move_out` is told where they are now. threads >= 1; the result is the same
  // with any number.
  explicit StrandClearance(const std::vector<Obstacle>& obstacles, int threads = 1);

  // Of the drawing's strands from `first` on, whose points begin at `first_point`. Afterwards no point but a
  // root is inside of an obstacle by more than kTolerance, if obstacles leave room between them. Returns how
  // many strands moved.
  long move_out(const std::vector<Obstacle>& now, StrandsDrawing& strands, std::size_t first,
                std::size_t first_point);
  static constexpr double kTolerance = 1e-5;  // m

 private:
  // The cells of a solid's box: 1 where something may be nearer than kHigh to its surface, or inside.
  struct NearCells {
    NearCells(const Solid& solid, double cell);
    bool may_touch(const Vector3d& point) const;  // in the solid's axes

    Vector3d low;
    double cell;  // m
    std::array<int, 3> size;
    std::vector<char> near;
  };
  struct Scratch;

  bool touches(const std::vector<Obstacle>& now, const Vector3d& point, double clearance) const;
  Vector3d way_out(const std::vector<Obstacle>& now, const Vector3d& point, double clearance) const;
  bool move_strand_out(const std::vector<Obstacle>& now, Vector3d* points, int count, std::uint32_t id,
                       Scratch& scratch) const;

  std::vector<std::optional<NearCells>> cells_;  // of each obstacle; none: its distance costs nothing
  StrandThreads threads_;
};

}  // namespace hair
