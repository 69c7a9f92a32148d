// STAFF ONLY. The engine's data, which the host and the kernels for each instruction set share.
//
// A group is kGroup strands with the same number of points, side by side: number (i, axis, strand) of x is at
// x[(3 i + axis) kGroup + strand]. So a vector of lanes holds the same number of several strands, whatever
// its width. A group that is not full repeats its last strand.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace hair::engine {

inline constexpr std::size_t kGroup = 8;

struct Group {
  int points = 0;
  // These follow each other in memory: x and v have 3 points kGroup numbers each, root and tangent (in the
  // head's axes) 3 kGroup each, rest_length kGroup.
  double *x = nullptr, *v = nullptr;
  double *root = nullptr, *tangent = nullptr;
  double* rest_length = nullptr;
  std::int64_t* broke_at = nullptr;  // kGroup
};

// Distances on a grid. Between the points they are interpolated (trilinear) and divided by the slope of that,
// which makes them right to first order. Deep inside there are places without a slope.
inline constexpr double kLeastSlope = 0.3;

struct GridView {
  const std::int16_t* distance;  // in units; point (i, j, k) is at ((k count[1] + j) count[0] + i)
  double unit;                   // m
  // A bit for each cell, at the index of its lowest point, is set if a corner is inside. Most hair needs only
  // this small table.
  const std::int32_t* reaches_inside;
  double low[3];
  double per_cell;  // 1 / spacing
  int count[3];     // >= 2 each
  float last[3];    // the largest number that is less than count - 1
};

// The rounding of places on the grid, m. They are in single precision, and are rounded at first and with each
// push, in each of three axes. A point seldom takes more than three pushes.
inline double place_rounding(const GridView& grid) {
  const int most = std::max({grid.count[0], grid.count[1], grid.count[2]});
  return 8 * 0x1p-24 * most / grid.per_cell;  // 4 sqrt(3) < 8
}

struct Pose {
  double turn[3][3];  // the head's rotation: world = turn * head + at
  double at[3];
};

// The constants of a step; lambda is the line density.
struct StepConstants {
  double h, per_h;
  double mass;     // 1 + h drag
  double push[3];  // h gravity + h drag wind
  double drag;     // h drag
  double stretch;  // h^2 EA / lambda: times 1/l0^2 it is h^2 k / m of a segment
  // h^2 EI / lambda: times 1/l0^2 it is h^2 k / m of a joint, m^2. The root's joint is twice as stiff.
  double bend, clamp;
  double length_tolerance;
  double friction, contact_depth;
  GridView grid;
  Pose after;
  // Maps to the grid, in cells, from the head's pose before the step and after it.
  Pose cells_before, cells_after;
  std::int64_t step;
};

// A thread's memory for strands of so many points.
inline constexpr std::size_t kFactorRow = 24, kNearRows = 9;
struct Scratch {
  double* factor;            // kFactorRow kGroup numbers a point
  double *moved, *other;     // positions, 3 kGroup numbers a point
  float* near;               // points near the head: kNearRows rows of near_row numbers
  std::int32_t* near_index;  // near_row
  std::size_t near_row;      // kGroup (points + 2)
};

// Advances a group by a step. All of `scratch` is aligned to 64 bytes.
using StepGroup = void (*)(const StepConstants&, const Group&, const Scratch& scratch);

struct Parts {
  bool bending, correction, contact;
};

// The step for the best instruction set of this machine that is not disabled now (hwy::DisableTargets).
StepGroup step_group_for(const Parts& parts);

}  // namespace hair::engine
