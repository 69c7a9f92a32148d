// H5. The non-linear post correction: restores the segments' lengths and removes the velocities that stretch
// them. Sources: the lecture, "Post solve correction" and "How to implement?"; X. Provot, "Deformation
// Constraints in a Mass-Spring Model" (Graphics Interface 1995); R. Bridson, R. Fedkiw and J. Anderson,
// "Robust Treatment of Collisions, Contact and Friction for Cloth Animation" (SIGGRAPH 2002), section 6.
//
// The root, particle 0, never moves: its mass is infinite. All other particles have their own mass: a
// correction along a segment moves its two ends in opposite directions, each in proportion to 1/mass, so that
// only the root gains or loses momentum. A segment of length l with the rest length l0 has the error |l - l0|
// / l0.
//
// A segment of length 0 has no direction. It takes the direction of the segment before it; the first segment
// takes root_tangent. A strand of 1 particle has nothing to correct.
#pragma once

#include "hair/strand.h"
#include "particles/vectors.h"

namespace hair {

using particles::Input;
using particles::Output;
using particles::Scratch;

struct CorrectionReport {
  int iterations = 0;  // sweeps over all segments, or Newton steps
  double error = 0;    // the largest remaining error, see below
  bool converged = false;
};

// `scratch` has this many columns of 3n numbers.
inline constexpr int kCorrectionScratch = 8;

// Successive relaxation (Provot): sweeps over the segments. For each segment it restores the length at once
// by moving the two ends along the segment. It repeats the sweeps until no error is above `tolerance`, or
// `most_sweeps` sweeps are done. The order within a sweep is free. `error` is the largest error of the
// returned x. A strand whose lengths are right already takes 0 sweeps.
//
// The convergence is slow: the number of sweeps grows with n^2.
CorrectionReport relax_lengths(const Strand& strand, double tolerance, int most_sweeps, Output x);

// The same result, fast enough for hair: finds the multipliers of all segments at once. The constraints'
// Newton step
//
//   J W J^T lambda = -C,   x += W J^T lambda,     C_i = |x_{i+1} - x_i| - l0_i,  J = dC/dx,  W = 1/mass
//
// has a tridiagonal matrix, since a segment touches only its two neighbours, and takes linear time. In a
// simulation a hair takes about 3 steps. Ends as above, after at most `most_iterations`. Any other method is
// allowed if it satisfies the conditions at the top.
//
// Newton's method alone diverges if a step turns segments far: if the root was flung away, or if masses
// differ by 1e6. For these cases any fallback is allowed, even one that ignores the masses; but x stays
// finite, and `converged` is true only if the lengths are right. Positions are rounded: a tolerance below
// 2^-51 max|x_i| / min(l0) may be treated as this value, but never as more than 1e-3. If the root is 1e10 m
// away, rounding leaves larger errors, and `converged` is false.
//
// For a hair of 200 segments whose lengths are wrong by a percent, Newton's method takes at most 8 steps, and
// relaxation takes hundreds of sweeps. For a single segment any method takes one step, or two for rounding.
CorrectionReport correct_lengths(const Strand& strand, double tolerance, int most_iterations, Output x,
                                 Scratch scratch);

// Velocities that do not stretch (Bridson): applies equal and opposite impulses along each segment to its two
// ends, until |u . (v_{i+1} - v_i)|, with u the segment's direction, is at most `tolerance` (m/s) for all
// segments, or `most_sweeps` sweeps are done; `error` is the largest remaining value. Any order of sweeps is
// allowed. Solving for all impulses at once is allowed, too: it takes one iteration, or some more for
// rounding, and at most two for a single segment. If all velocities are right already, it takes none.
//
// In all three functions `converged` is false if a number is not finite.
CorrectionReport correct_velocities(const Strand& strand, Input x, double tolerance, int most_sweeps,
                                    Output v, Scratch scratch);

}  // namespace hair
