// H5. The non-linear post correction: segments get their length back, and velocities stop to stretch them.
// Sources: the lecture, "Post solve correction" and "How to implement?"; X. Provot, "Deformation Constraints in a
// Mass-Spring Model" (Graphics Interface 1995); R. Bridson, R. Fedkiw and J. Anderson, "Robust Treatment of
// Collisions, Contact and Friction for Cloth Animation" (SIGGRAPH 2002), section 6.
//
// The root, particle 0, never moves: it counts as infinitely heavy. Every other particle i counts with its
// mass: what acts along a segment moves its two ends in opposite directions, each by 1/mass, so that nothing
// but the root gains or loses momentum. With l the length of a segment and l0 its rest length, its error is
// |l - l0| / l0.
//
// A segment of length 0 has no direction. It gets that of the segment before it; the first one, root_tangent.
// A strand of 1 particle is always right.
#pragma once

#include "hair/strand.h"
#include "particles/vectors.h"

namespace hair {

using particles::Input;
using particles::Output;
using particles::Scratch;

struct CorrectionReport {
  int iterations = 0;  // sweeps over all segments, or Newton steps
  double error = 0;    // the largest that is left, see below
  bool converged = false;
};

// Columns of 3n numbers that `scratch` has.
inline constexpr int kCorrectionScratch = 8;

// Successive relaxation (Provot): sweeps over the segments, and gives each its length at once by moving its two
// ends along it; again until no error is above `tolerance`, or `most_sweeps` sweeps are done. The order of a
// sweep is free. `error` is the largest error of the x that is returned; if no sweep is needed, none is taken.
//
// Converges slowly: the longer the strand the more sweeps, growing with n^2.
CorrectionReport relax_lengths(const Strand& strand, double tolerance, int most_sweeps, Output x);

// The same, fit for hair: finds the multipliers of all segments at once. The constraints' Newton step
//
//   J W J^T lambda = -C,   x += W J^T lambda,     C_i = |x_{i+1} - x_i| - l0_i,  J = dC/dx,  W = 1/mass
//
// has a tridiagonal matrix, since a segment meets only its two neighbours, and takes linear time. A hair takes
// about 3 steps in a simulation. Ends as above, after at most `most_iterations`. Any method that keeps the
// promises at the top will do.
//
// Newton's method alone goes astray where a step turns segments far: after a root that was flung away, or with masses
// that differ by 1e6. What is tried then is free, and may leave the masses out of account; but x stays finite, and
// `converged` is true only if the lengths are right. Positions round: a tolerance below 2^-51 max|x_i| / min(l0) may
// count as that.
CorrectionReport correct_lengths(const Strand& strand, double tolerance, int most_iterations, Output x,
                                 Scratch scratch);

// Velocities that do not stretch (Bridson): an impulse along each segment, equal and opposite on its two ends,
// until u . (v_{i+1} - v_i), with u the segment's direction, is at most `tolerance` (m/s) in size for all of them:
// `error` is the largest that is left. Any order of sweeps will do, and so will solving for all impulses at once.
CorrectionReport correct_velocities(const Strand& strand, Input x, double tolerance, int most_sweeps,
                                    Output v, Scratch scratch);

}  // namespace hair
