// STAFF ONLY. What the bounds of the hidden cases are counted in.
#pragma once

namespace grader {

inline constexpr double kUnit = 0x1p-53;  // u: one rounding's relative error is at most this

}  // namespace grader
