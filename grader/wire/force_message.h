// STAFF ONLY. The worker's questions about a force that the suite holds: operators of Session::product, each
// with its vectors concatenated into one.
#pragma once

namespace grader {

// Far from the numbers of matrices, which start at 0, because an exercise may use both. A question holds what is to
// be added to, so that sums have the same bits wherever the force is.
inline constexpr int kForceEnergy = 100;  // x             -> energy, one number
inline constexpr int kForceForce = 101;   // x, v, f       -> f, 3n
inline constexpr int kForceDfdx = 102;    // x, v, dx, df  -> df + (df/dx) dx, 3n
inline constexpr int kForceDfdv = 103;    // x, v, dv, df  -> df + (df/dv) dv, 3n

// The vectors of a question.
inline int vectors_of_question(int which) {
  return which == kForceEnergy ? 1 : which == kForceForce ? 3 : 4;
}

}  // namespace grader
