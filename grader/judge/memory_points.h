// STAFF ONLY. Declares the category for code without memory errors.
#pragma once

namespace grader::inline judge {

inline constexpr const char* kMemoryTitle = "No memory errors";

// The worker with sanitizers prints to the job's log with this ending. The output differs from run to run,
// and no report shows it.
inline constexpr const char* kSanitisedLog = ".sanitised";

}  // namespace grader::judge
