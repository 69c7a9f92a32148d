// STAFF ONLY. The unit of the hidden cases' bounds.
#pragma once

namespace grader::inline judge {

inline constexpr double kUnit = 0x1p-53;  // u: one rounding's relative error is at most this

}  // namespace grader::judge
