// STAFF ONLY. The worker's questions about a force that the suite holds: operators of Session::product, each
// with its vectors concatenated into one.
#pragma once

namespace grader {

// Far from the numbers of matrices, which start at 0, because an exercise may use both.
inline constexpr int kForceEnergy = 100;  // x          -> energy, one number
inline constexpr int kForceForce = 101;   // x, v       -> f, 3n
inline constexpr int kForceDfdx = 102;    // x, v, dx   -> (df/dx) dx, 3n
inline constexpr int kForceDfdv = 103;    // x, v, dv   -> (df/dv) dv, 3n

}  // namespace grader
