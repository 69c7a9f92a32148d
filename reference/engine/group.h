// STAFF ONLY. The engine's data: what the host and the kernels for each instruction set share.
//
// A group is kGroup strands with the same number of points, side by side: number (i, axis, strand) of x is at
// x[(3 i + axis) kGroup + strand]. So a vector of lanes holds the same number of several strands, whatever its width.
// A group that is not full repeats its last strand.
#pragma once

#include <cstddef>
#include <cstdint>

namespace hair::engine {

inline constexpr std::size_t kGroup = 8;

struct Group {
  int points = 0;
  // One after the other: 3 points kGroup numbers each, 3 kGroup numbers each (in the head's axes), kGroup numbers.
  double *x = nullptr, *v = nullptr;
  double *root = nullptr, *tangent = nullptr;
  double* rest_length = nullptr;
  std::int64_t* broke_at = nullptr;  // kGroup
};

// Distances on a grid, and what lies between them: by trilinear interpolation, divided by the slope of what is interpolated,
// which makes them right to first order. Deep inside there are places without a slope.
inline constexpr double kLeastSlope = 0.3;

struct GridView {
  const float* distance;  // of point (i, j, k) at ((k count[1] + j) count[0] + i)
  // A bit for each cell, with the index of its lowest point: whether one of its corners is inside. It is a small table: most
  // hair needs no more.
  const std::int32_t* reaches_inside;
  double low[3];
  double per_cell;  // 1 / spacing
  int count[3];     // >= 2 each
};

struct Pose {
  double turn[3][3];  // world = turn * head + at
  double at[3];
};

// The constants of a step; lambda is the line density.
struct StepConstants {
  double h, per_h;
  double mass;     // 1 + h drag
  double push[3];  // h gravity + h drag wind
  double drag;     // h drag
  double stretch;  // h^2 EA / lambda: times 1/l0^2 it is h^2 k / m of a segment
  double bend,
      clamp;  // h^2 EI / lambda: times 1/l0^2 it is h^2 k / m of a joint, m^2; the root's joint is twice as stiff
  double length_tolerance;
  double friction, contact_depth;
  GridView grid;
  Pose before, after;
  std::int64_t step;
};

// Doubles of scratch memory for strands of so many points: rows of the factor, and two sets of positions.
inline constexpr std::size_t kFactorRow = 24;
constexpr std::size_t scratch_size(std::size_t points) {
  return points * (kFactorRow + 6) * kGroup;
}

// Advances a group by a step. `scratch` is aligned to 64 bytes.
using StepGroup = void (*)(const StepConstants&, const Group&, double* scratch);

struct Parts {
  bool bending, correction, contact;
};

// For the best instruction set of this machine that is not disabled now (hwy::DisableTargets).
StepGroup step_group_for(const Parts& parts);

}  // namespace hair::engine
