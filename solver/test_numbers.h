// STAFF ONLY. Constants that the tests of all exercises use.
#pragma once

#include <limits>

namespace reference_tests {

inline constexpr double kUnit = 0x1p-53;  // u: one rounding's relative error is at most this
inline constexpr double kInf = std::numeric_limits<double>::infinity();
inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kGravity = 9.81;  // m/s^2

}  // namespace reference_tests
