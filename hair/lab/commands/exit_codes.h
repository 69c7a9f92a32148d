// What hairlab returns: 0 when all is done, and else one of these.
#pragma once

namespace hair {

// Something broke on the way, or did not hold (what came before is kept), or the code of an exercise threw.
inline constexpr int kBroke = 1;
inline constexpr int kBadInput = 2;       // or usage
inline constexpr int kNotWritten = 3;     // an exercise that is needed
inline constexpr int kInterrupted = 130;  // what was finished is kept

}  // namespace hair
