// STAFF ONLY. The category for a code without memory errors.
#pragma once

namespace grader::inline judge {

inline constexpr const char* kMemoryTitle = "No memory errors";

// What the worker with sanitizers prints is in the job's log with this ending. It differs from run to run: no
// report shows it.
inline constexpr const char* kSanitisedLog = ".sanitised";

}  // namespace grader::judge
