// Keeps drawn strands out of solids. Guides stay outside of a head, but strands between them cut corners, and
// so do clumps and fly-aways. A point inside moves along the distance's gradient to the surface, and a little
// beyond it; its neighbours move along, so that there is no kink, and lengths are restored if there is space.
// Roots stay, because they are on the scalp.
//
// It has no effect on the motion, and costs time only for strands near a solid, which a coarse grid finds.
// The grid is made once. Without obstacles it does nothing.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "hair/obstacles/obstacles.h"
#include "hair/render/drawing.h"
#include "hair/simulation/strand_threads.h"

namespace hair {

class StrandClearance {
 public:
  // The layer above a surface in which strands are kept, m: each strand has its own height in it. Nearer to
  // the root, strands are kept out only up to the lower bound.
  static constexpr double kLow = 0.0008, kHigh = 0.0025;

  // obstacles: those that `move_out` gets with their present positions. threads >= 1; the result is the same
  // with any number.
  explicit StrandClearance(const std::vector<Obstacle>& obstacles, int threads = 1);

  // Moves the drawing's strands from `first` on, whose points begin at `first_point`. Afterwards no point but
  // a root is inside of an obstacle by more than kTolerance, if obstacles leave space between them. Returns
  // the number of moved strands.
  long move_out(const std::vector<Obstacle>& now, StrandsDrawing& strands, std::size_t first,
                std::size_t first_point);
  static constexpr double kTolerance = 1e-5;  // m

 private:
  // The cells of a solid's box: 1 if a point of the cell may be inside, or nearer than kHigh to the surface.
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

  std::vector<std::optional<NearCells>> cells_;  // for each obstacle; none: its distance is cheap
  StrandThreads threads_;
};

}  // namespace hair
