// hairlab's exit codes: 0 for success, otherwise one of these.
#pragma once

namespace hair {

// Something failed during the run, a check did not hold (earlier results are kept), or an exercise's code
// threw.
inline constexpr int kBroke = 1;
inline constexpr int kBadInput = 2;       // or wrong usage
inline constexpr int kNotWritten = 3;     // a required exercise is a stub
inline constexpr int kInterrupted = 130;  // finished results are kept

}  // namespace hair
